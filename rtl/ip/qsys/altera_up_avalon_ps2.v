// altera_up_avalon_ps2.v - the University Program's PS/2 controller
//
//   +0 data      read: RAVAIL[31:16] bytes with this one, RVALID bit 15, the oldest byte, which
//                goes away; while none waits RVALID is 0, and the byte that was read last stands
//                there once more.  A read that leaves the lowest byte out takes nothing away.
//                write: a byte to the device; it waits until the byte has been sent or has failed
//   +4 control   RE bit 0: interrupt while RI; RI bit 8: RE, and a byte waits; CE bit 10: a byte
//                could not be sent, which a write of anything to this byte clears
//
//   from the device  11 falling edges of CLK: start 0, 8 bits from bit 0, parity and stop, at which
//                    nobody looks; a frame without a start bit is dropped
//   to the device    CLK low for 120 us, then DAT low and CLK open; at each falling edge that the
//                    device then makes the next bit: 8 bits, odd parity, open for stop; at the
//                    eleventh it acknowledges; when CLK rises after it the byte has been sent
//
// The wires are sampled every TICK clocks, 1.28 us; a level of CLK counts when it has been the same
// four times.  A device has 15 ms to begin to take a byte and 2 ms to take it.  A frame from the
// device of which an edge does not come within 2 ms is forgotten.  256 bytes wait; others are lost.
//
// Source: Intel FPGA University Program, PS/2 Controller for DE-Series Boards, which never forgets
// a frame that broke off; IBM Personal System/2 Hardware Interface Technical Reference.

`default_nettype none

module altera_up_avalon_ps2 #(parameter TICK = 64) (
    input  wire        clk,
    input  wire        reset,
    input  wire        address,
    input  wire        chipselect,
    // verilator lint_off UNUSED
    input  wire [3:0]  byteenable,
    input  wire        read,
    input  wire        write,
    input  wire [31:0] writedata,
    // verilator lint_on UNUSED
    output wire [31:0] readdata,
    output wire        waitrequest,
    output wire        irq,
    inout  wire        PS2_CLK,
    inout  wire        PS2_DAT
);
    localparam [13:0] INHIBIT = 14'd94, BETWEEN = 14'd1_563, PATIENCE = 14'd11_719;  // ticks
    localparam [1:0]  RECEIVES = 2'd0, INHIBITS = 2'd1, SENDS = 2'd2, RELEASES = 2'd3;
    localparam [3:0]  STOP = 4'd9, LAST = 4'd10;  // edges

    // ---- Wires ----
    reg [15:0] tick_q;
    reg [3:0]  clk_was_q;
    reg        clk_q, dat_q, clk_low_q, dat_low_q;
    wire       tick  = tick_q == 16'd0;
    wire       falls = clk_q && clk_was_q == 4'h0;

    assign PS2_CLK = clk_low_q ? 1'b0 : 1'bz;
    assign PS2_DAT = dat_low_q ? 1'b0 : 1'bz;

    always @(posedge clk) begin
        tick_q <= tick ? TICK[15:0] - 16'd1 : tick_q - 16'd1;
        if (tick) begin
            clk_was_q <= {clk_was_q[2:0], PS2_CLK};
            clk_q     <= clk_was_q == 4'hf || (clk_q && clk_was_q != 4'h0);
            dat_q     <= PS2_DAT;
        end
        if (reset) begin
            tick_q    <= 16'd0;
            clk_was_q <= 4'hf;
            clk_q     <= 1'b1;
        end
    end

    // ---- Frames ----
    reg [1:0]  state_q;
    reg [13:0] timer_q;         // ticks
    reg [3:0]  edge_q;          // falling edges so far
    reg [10:0] bits_q;          // received, or still to be sent: the next one in bit 0
    reg        come_q, done_q;  // for one clock

    wire of_data = chipselect && !address && byteenable[0];
    wire starts  = of_data && write && state_q == RECEIVES && !done_q;
    wire late    = timer_q == (state_q == SENDS && edge_q == 4'd0 ? PATIENCE : BETWEEN);
    wire fails   = tick && late && (state_q == SENDS || state_q == RELEASES);

    always @(posedge clk) begin
        come_q <= 1'b0;
        done_q <= fails || (tick && state_q == RELEASES && clk_q);
        if (starts) begin
            state_q   <= INHIBITS;
            clk_low_q <= 1'b1;
            timer_q   <= 14'd0;
            bits_q    <= {1'b0, 1'b1, ~^writedata[7:0], writedata[7:0]};
        end else if (fails) begin
            state_q   <= RECEIVES;
            dat_low_q <= 1'b0;
            edge_q    <= 4'd0;
        end else if (tick) begin
            timer_q <= timer_q + 14'd1;
            case (state_q)
                RECEIVES: begin
                    if (edge_q == 4'd0 || late) {timer_q, edge_q} <= 18'd0;
                    if (falls) begin
                        timer_q <= 14'd0;
                        bits_q  <= {dat_q, bits_q[10:1]};
                        edge_q  <= edge_q == LAST ? 4'd0 : edge_q + 4'd1;
                        come_q  <= edge_q == LAST && !bits_q[1];
                    end
                end
                INHIBITS:
                    if (timer_q == INHIBIT) begin
                        state_q   <= SENDS;
                        clk_low_q <= 1'b0;
                        dat_low_q <= 1'b1;
                        {timer_q, edge_q} <= 18'd0;
                    end
                SENDS:
                    if (falls) begin
                        if (edge_q == 4'd0) timer_q <= 14'd0;
                        if (edge_q == LAST) state_q <= RELEASES;
                        dat_low_q <= edge_q < STOP && !bits_q[0];
                        bits_q    <= bits_q >> 1;
                        edge_q    <= edge_q + 4'd1;
                    end
                RELEASES:
                    if (clk_q) begin
                        state_q <= RECEIVES;
                        edge_q  <= 4'd0;
                    end
            endcase
        end
        if (reset) begin
            state_q   <= RECEIVES;
            edge_q    <= 4'd0;
            clk_low_q <= 1'b0;
            dat_low_q <= 1'b0;
            done_q    <= 1'b0;
        end
    end

    // ---- Registers ----
    wire [7:0] head;
    wire [8:0] count;
    reg        re_q, ce_q;
    wire       some = count != 9'd0;
    wire       ri   = re_q && some;

    assign irq         = ri;
    assign waitrequest = of_data && write && !done_q;
    assign readdata    = address ? {21'd0, ce_q, 1'b0, ri, 7'd0, re_q}
                                 : {7'd0, count, some, 7'd0, head};

    // bits_q is stop, parity, the byte, start.
    de1sim_up_fifo #(.WIDTH(8), .LOG2(8)) fifo (
        .clk_i(clk), .rst_i(reset), .push_i(come_q), .wdata_i(bits_q[8:1]),
        .pop_i(of_data && read), .rdata_o(head), .count_o(count)
    );

    always @(posedge clk) begin
        if (chipselect && write && address) begin
            if (byteenable[0]) re_q <= writedata[0];
            if (byteenable[1]) ce_q <= 1'b0;
        end
        if (fails) ce_q <= 1'b1;
        if (reset) {re_q, ce_q} <= 2'b00;
    end
endmodule

`default_nettype wire
