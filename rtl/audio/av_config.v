// av_config.v - the DE1-SoC Computer's audio/video configuration: words to the codec by hand
//
//   +0 CONTROL   a write of RESET bit 0 sets the codec up as at reset
//   +4 STATUS    ACK bit 0: 1 = the last word was not acknowledged; RDY bit 1: no word is on its
//                way; AIS bit 8: the set-up has succeeded; CFG[23:16] = 0: an audio codec alone
//   +8 ADDRESS   the codec's register, bits 6:0
//   +C DATA      9 bits; a write sends them to that register, 0.3 ms
//
// A write of ADDRESS or DATA while RDY is 0 makes the bus wait until it is 1.
//
// DATA reads what was written last: the codec cannot be read.  audio.v answers the reads.
//
// Source: the core's register header of Altera's University Program (HAL), whose driver waits for
// ACK = 0.
//
// Not handled: the interrupt (RIE), other devices than the codec.

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
    output reg  [6:0]  address_o,
    output reg  [8:0]  data_o,
    input  wire        busy_i,
    output wire        ready_o,     // RDY
    output wire        hold_o,      // a write waits; its address and data stay meanwhile

    output wire        awake_o
);
    `include "regmap.vh"

    assign ready_o = !(busy_i || send_o || restart_o);

    reg  waits_q;
    wire writes = waits_q || (we_i && wstrb_i[0] && waddr_i[3]);   // ADDRESS, DATA
    wire sends  = waddr_i[3:0] == AV_CONFIG_DATA[3:0];

    assign hold_o  = writes && !ready_o;
    assign awake_o = restart_o || send_o || waits_q;

    always @(posedge clk_i) begin
        if (writes && ready_o) begin
            if (sends) data_o <= {wstrb_i[1] && wdata_i[8], wdata_i[7:0]};
            else address_o <= wdata_i[6:0];
        end
        send_o    <= writes && sends && ready_o;
        waits_q   <= hold_o;
        restart_o <= we_i && waddr_i[3:0] == AV_CONFIG_CONTROL[3:0] && wstrb_i[0]
                     && wdata_i[AV_CONFIG_CONTROL_RESET_LSB];
        if (rst_i) begin
            restart_o <= 1'b0;
            send_o    <= 1'b0;
            waits_q   <= 1'b0;
            address_o <= 7'd0;
            data_o    <= 9'd0;
        end
    end
endmodule

`default_nettype wire
