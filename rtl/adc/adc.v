// adc.v - the DE1-SoC Computer's AD converter port, on an LTC2308
//
//   +00 ... +1C  CH_0 ... CH_7   bits 11:0 the voltage, 1 mV each; bit 15, while channels are
//                                converted continuously: new since last read
//   +00          CH_0            a write of any value converts all channels once; a read before
//                                the end makes the bus wait for it
//   +04          CH_1            a write of bit 0 = 1 converts them continuously
//
// A round is nine transfers, because a transfer returns the conversion that the previous one asked
// for.  A transfer is CONVST for one clock, 2.5 us for the conversion, then 12 bits at 12.5 MHz
// each way.
//
//   CONVST _/^\________ ... ______________________________
//   SCK    ____________ ... __/^\_/^\_/^\ ... /^\_________   a bit is read as SCK rises and
//   SDI    ____________ ... X S/D X O/S X ... X___________   changes as it falls
//
// A round takes 9 x 88 clocks, 31.7 us; at its end all channels are new.  A write during a round
// asks for nothing.
//
// Source: Linear Technology, LTC2308; the ADC Controller's Verilog in the DE1-SoC Computer.
//
// Of the core there are generations.  The older ones have no bit 15; those that find out which
// converter the board has take one or two wrong rounds after a reset for it.  Here there are none.
//
// Not handled: the AD7928 that early revisions of the board have in its place.

`default_nettype none

module adc (
    input  wire        clk_i,           // 25 MHz
    input  wire        rst_i,

    input  wire        we_i,
    // Only the register's offset in the block and bit 0 are used.
    // verilator lint_off UNUSED
    input  wire [3:0]  wstrb_i,
    input  wire [11:0] waddr_i,
    input  wire [31:0] wdata_i,
    input  wire [11:0] raddr_i,
    // verilator lint_on UNUSED
    input  wire        re_i,
    output reg  [31:0] rdata_o,
    output wire        rhold_o,         // the read has to wait

    output reg         convst_o,
    output reg         sck_o,
    output wire        sdi_o,
    input  wire        sdo_i,

    output wire        awake_o
);
    `include "regmap.vh"

    localparam [6:0] CONVERTED = 7'd63,              // SCK rises 2.56 us after CONVST
                     LAST      = CONVERTED + 7'd24;  // two for each bit
    localparam [3:0] LAST_TRANSFER = 4'd8;

    reg        busy_q, asked_q, auto_q;
    reg        read_q;       // a read waits
    reg [3:0]  transfer_q;   // 0 - 7: asks for this channel, returns the previous one
    reg [6:0]  step_q;
    reg [11:0] bits_q;       // sent from the top, received at the bottom

    assign sdi_o   = bits_q[11];
    assign awake_o = busy_q || asked_q || auto_q || read_q || rdata_o != 32'd0;

    // Single-ended, unipolar, awake: S/D, O/S, S1, S0, UNI, SLP.  O/S is the channel's lowest bit.
    function [11:0] request;
        input [2:0] channel;
        request = {1'b1, channel[0], channel[2:1], 1'b1, 1'b0, 6'd0};
    endfunction

    // ---- Transfers --------------------------------------------------------
    wire done  = busy_q && step_q == LAST;
    wire ended = done && transfer_q == LAST_TRANSFER;

    always @(posedge clk_i) begin
        if (we_i && waddr_i[4:0] == ADC_CH_0[4:0] && (!busy_q || ended)) asked_q <= 1'b1;
        if (we_i && waddr_i[4:0] == ADC_CH_1[4:0] && wstrb_i[0]) auto_q <= wdata_i[0];
        if (!busy_q) begin
            if (auto_q || asked_q) begin
                busy_q     <= 1'b1;
                asked_q    <= we_i && waddr_i[4:0] == ADC_CH_0[4:0];
                convst_o   <= 1'b1;
                transfer_q <= 4'd0;
                step_q     <= 7'd0;
                bits_q     <= request(3'd0);
            end
        end else begin
            convst_o <= 1'b0;
            step_q   <= step_q + 7'd1;
            if (step_q >= CONVERTED && step_q != LAST) begin
                sck_o <= !sck_o;
                if (sck_o) bits_q <= {bits_q[10:0], sdo_i};
            end
            if (done) begin
                step_q     <= 7'd0;
                transfer_q <= transfer_q + 4'd1;
                bits_q     <= request(transfer_q[2:0] + 3'd1);
                convst_o   <= !ended;
                busy_q     <= !ended;
            end
        end
        if (rst_i) begin
            busy_q   <= 1'b0;
            asked_q  <= 1'b0;
            auto_q   <= 1'b0;
            convst_o <= 1'b0;
            sck_o    <= 1'b0;
        end
    end

    // ---- Channels ---------------------------------------------------------
    // raddr_i stays as it is while the bus waits.
    wire answers = (re_i || read_q) && !rhold_o;

    assign rhold_o = (re_i || read_q) && (busy_q || asked_q) && !auto_q;

    reg [95:0] values_q;
    reg [7:0]  new_q;

    integer n;
    always @(posedge clk_i) begin
        if (answers && auto_q) new_q[raddr_i[4:2]] <= 1'b0;
        for (n = 0; n < 8; n = n + 1)
            if (done && transfer_q == n[3:0] + 4'd1) values_q[12 * n +: 12] <= bits_q;
        if (ended) new_q <= 8'hff;
        if (rst_i) new_q <= 8'd0;
    end

    function [31:0] channel;
        input [2:0] number;
        integer k;
        begin
            channel = 32'd0;
            for (k = 0; k < 8; k = k + 1)
                if (number == k[2:0])
                    channel = {16'd0, new_q[k] && auto_q, 3'd0, values_q[12 * k +: 12]};
        end
    endfunction

    always @(posedge clk_i) begin
        rdata_o <= 32'd0;
        if (answers) rdata_o <= channel(raddr_i[4:2]);
        read_q <= rhold_o && !rst_i;
    end
endmodule

`default_nettype wire
