// av_config.v - the DE1-SoC Computer's audio/video configuration: words to the codec by hand
//
//   +0 CONTROL   a write of RESET bit 0 clears these registers and sets the codec up as at reset;
//                RIE bits 2:1, which only read as written; DEVICE bits 17:16: 0 the codec, 1 the
//                video decoder, others nothing on this board
//   +4 STATUS    ACK bit 0: 1 = the last word was not acknowledged; RDY bit 1: no word is on its
//                way; AIS bit 8: the set-up has succeeded; CFG[23:16] = 3: a DE1-SoC
//   +8 ADDRESS   the device's register, 8 bits; the codec's have 7
//   +C DATA      9 bits for the codec, 8 for the decoder; a write sends them there, 0.3 ms
//
// A write of DATA while RDY is 0 makes the bus wait until it is 1.  DATA reads what was written
// last.  audio.v answers the reads.
//
// Source: the core's Verilog in the DE1-SoC Computer.  Its interrupt is not connected there.
//
// Not handled: reads of the decoder's registers.

`default_nettype none

module av_config (
    input  wire        clk_i,
    input  wire        rst_i,

    input  wire        we_i,
    // Only the register's offset in the block is used; registers are narrow.
    // verilator lint_off UNUSED
    input  wire [3:0]  wstrb_i,
    input  wire [11:0] waddr_i,
    input  wire [31:0] wdata_i,
    // verilator lint_on UNUSED

    output reg         restart_o,   // to codec_setup.v
    output reg         send_o,
    output wire [6:0]  slave_o,     // of I2C
    output wire [15:0] word_o,
    output reg  [3:0]  control_o,   // DEVICE, RIE
    output reg  [7:0]  address_o,
    output reg  [8:0]  data_o,
    input  wire        busy_i,
    output wire        ready_o,     // RDY
    output wire        hold_o,      // a write waits; its data stay meanwhile

    output wire        awake_o
);
    `include "regmap.vh"

    localparam [1:0] CODEC = 2'd0, DECODER = 2'd1;

    assign ready_o = !(busy_i || send_o || restart_o);

    assign slave_o = control_o[3:2] == CODEC ? 7'h1a : control_o[3:2] == DECODER ? 7'h20 : 7'h21;
    assign word_o  = control_o[3:2] == CODEC ? {address_o[6:0], data_o}
                     : {address_o, data_o[7:0]};

    reg  waits_q;
    wire writes = waits_q || (we_i && waddr_i[3:0] == AV_CONFIG_DATA[3:0]);

    assign hold_o  = writes && !ready_o;
    assign awake_o = restart_o || send_o || waits_q;

    always @(posedge clk_i) begin
        if (writes && ready_o) begin
            if (wstrb_i[0]) data_o[7:0] <= wdata_i[7:0];
            if (wstrb_i[1]) data_o[8] <= wdata_i[8];
        end
        send_o    <= writes && ready_o;
        waits_q   <= hold_o;
        restart_o <= 1'b0;
        if (we_i) case (waddr_i[3:0])
            AV_CONFIG_CONTROL[3:0]: begin
                if (wstrb_i[0]) control_o[1:0] <= wdata_i[AV_CONFIG_CONTROL_RIE_LSB +: 2];
                if (wstrb_i[2]) control_o[3:2] <= wdata_i[AV_CONFIG_CONTROL_DEVICE_LSB +: 2];
                restart_o <= wstrb_i[0] && wdata_i[AV_CONFIG_CONTROL_RESET_LSB];
            end
            AV_CONFIG_ADDRESS[3:0]: if (wstrb_i[0]) address_o <= wdata_i[7:0];
            default: ;
        endcase
        if (rst_i) begin
            restart_o <= 1'b0;
            send_o    <= 1'b0;
            waits_q   <= 1'b0;
        end
        if (restart_o || rst_i) begin
            control_o <= 4'd0;
            address_o <= 8'd0;
            data_o    <= AV_CONFIG_DATA_RESET[8:0];
        end
    end
endmodule

`default_nettype wire
