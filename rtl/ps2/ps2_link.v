// ps2_link.v - bytes over PS/2's two wires, from the device and to it
//
//   device to host:  CLK ~~~|_|~|_|~ ... 11 falling edges: start 0, 8 bits from bit 0, parity and
//                    stop, at which nobody looks; a frame without a start bit is dropped
//   host to device:  CLK low for 120 us, then DAT low and CLK open; at each falling edge that the
//                    device then makes, the next bit: 8 bits, odd parity, open for stop; at the
//                    eleventh the device acknowledges by DAT low, at which nobody looks either;
//                    when CLK rises after it the byte has been sent
//
// The wires are sampled once per tick; a level counts when it has been the same for four ticks, 4
// to 5 us.  Both are open collectors with pull-ups.  A device has 15 ms to begin to take a byte,
// and 2 ms to take it; otherwise sending has failed.  A frame from the device of which an edge does
// not come within 2 ms is forgotten.
//
// Source: IBM Personal System/2 Hardware Interface Technical Reference, keyboard and auxiliary
// device controller; University Program, PS/2 Core for Altera DE-Series Boards, which never forgets
// a frame that broke off.

`default_nettype none

module ps2_link (
    input  wire       clk_i,
    input  wire       rst_i,
    input  wire       tick_i,        // every 32 clocks, 1.28 us

    input  wire       send_i,        // not while busy_o
    input  wire [7:0] send_data_i,   // valid with send_i
    output reg        busy_o,        // a byte is being sent
    output reg        failed_o,      // for one tick: the device was not there, or too slow

    output reg        come_o,        // for one tick, with come_data_o
    output wire [7:0] come_data_o,

    input  wire       ps2_clk_i,     // asynchronous
    input  wire       ps2_dat_i,
    output reg        ps2_clk_low_o, // 1 = pull low
    output reg        ps2_dat_low_o,

    output wire       wants_tick_o   // the next tick changes something
);
    localparam [13:0] INHIBIT  = 14'd94;        // 120 us, in ticks
    localparam [13:0] BETWEEN  = 14'd1_563;     // 2 ms
    localparam [13:0] PATIENCE = 14'd11_719;    // 15 ms
    localparam [3:0]  LAST     = 4'd10;         // edge of 11
    localparam [3:0]  TAKEN    = 4'd11;         // sent all, CLK has yet to rise

    // ---- Wires: a flip-flop that may be metastable, and those that sample it a tick later ----
    reg [1:0]  meta_q;
    reg [3:0]  clk_was_q;
    reg        clk_q, dat_q;

    always @(posedge clk_i) if (tick_i || rst_i) begin
        clk_q     <= rst_i || clk_was_q == 4'hf || (clk_q && clk_was_q != 4'h0);
        clk_was_q <= rst_i ? 4'hf : {clk_was_q[2:0], meta_q[1]};
        dat_q     <= meta_q[0];
        meta_q    <= {ps2_clk_i, ps2_dat_i};
    end

    // ---- Frames -----------------------------------------------------------
    reg [13:0] timer_q;          // ticks
    reg [3:0]  edge_q;           // falling edges so far
    reg [9:0]  bits_q;           // received, or still to be sent: the next one in bit 0

    assign come_data_o = bits_q[7:0];

    // CLK is held low before a byte is sent, and released when INHIBIT is over.
    wire opens = ps2_clk_low_o && timer_q == INHIBIT;
    wire falls = !ps2_clk_low_o && clk_q && clk_was_q == 4'h0;
    wire ends  = edge_q == TAKEN && !clk_q && clk_was_q == 4'hf;
    wire late  = !ps2_clk_low_o && timer_q == (busy_o && edge_q == 4'd0 ? PATIENCE : BETWEEN);

    // At rest no byte is under way, and the levels of both wires have passed the filter.
    reg [1:0] wires_q;

    always @(posedge clk_i) wires_q <= {ps2_clk_i, ps2_dat_i};

    assign wants_tick_o = busy_o || failed_o || come_o || edge_q != 4'd0 || timer_q != 14'd0
                          || ps2_dat_low_o || ps2_clk_low_o || wires_q != meta_q
                          || {4{meta_q[1]}} != clk_was_q || {clk_q, dat_q} != meta_q;

    always @(posedge clk_i) if (tick_i || send_i || rst_i) begin
        if (send_i || rst_i) begin
            come_o        <= 1'b0;
            failed_o      <= 1'b0;
            ps2_dat_low_o <= 1'b0;
            bits_q        <= {1'b1, ~^send_data_i, send_data_i};
            timer_q       <= 14'd0;
            edge_q        <= 4'd0;
            busy_o        <= !rst_i;
            ps2_clk_low_o <= !rst_i;
        end else if (falls && !(late && busy_o && edge_q != 4'd0)) begin
            // Now: stop on the wire; in bits_q start, data, parity.
            come_o        <= !busy_o && edge_q == LAST && !bits_q[0];
            failed_o      <= 1'b0;
            ps2_dat_low_o <= busy_o && edge_q != LAST && !bits_q[0];
            bits_q        <= {busy_o || dat_q, bits_q[9:1]};
            timer_q       <= busy_o && edge_q != 4'd0 ? timer_q + 14'd1 : 14'd0;
            edge_q        <= edge_q == LAST && !busy_o ? 4'd0 : edge_q + 4'd1;
        end else begin
            come_o        <= 1'b0;
            failed_o      <= late && busy_o && !ends;
            if (opens) begin
                ps2_clk_low_o <= 1'b0;
                ps2_dat_low_o <= 1'b1;       // the start bit
                timer_q       <= 14'd0;
            end else if (late || ends) begin
                ps2_dat_low_o <= 1'b0;
                edge_q        <= 4'd0;
                busy_o        <= 1'b0;
            end else begin
                timer_q <= busy_o || edge_q != 4'd0 ? timer_q + 14'd1 : 14'd0;
            end
        end
    end
endmodule

`default_nettype wire
