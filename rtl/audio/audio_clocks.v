// audio_clocks.v - XCK, BCLK and LRCK of a WM8731 in slave mode, all from 25 MHz
//
//   fast_i   XCK         BCLK                      LRCK                       XCK / LRCK
//   0        12.5 MHz    520.83 kHz (48 clocks)    8138.02 Hz (3072 clocks)   1536
//   1        12.5 MHz    3.125 MHz  (8 clocks)     48828.125 Hz (512 clocks)  256
//
// The two ratios are those of the codec's normal mode for 8 and 48 kHz from 12.288 MHz.  A frame is
// 64 BCLKs: LRCK is low for slots 0 to 31 and high for 32 to 63, and moves when BCLK falls.
// fast_i counts from the next edge of BCLK on, so every frame has 64 whole BCLKs.

`default_nettype none

module audio_clocks (
    input  wire       clk_i,
    input  wire       rst_i,
    // Half a BCLK is 24 clocks at most.
    // verilator lint_off UNUSED
    input  wire [29:0] now_i,
    // verilator lint_on UNUSED

    input  wire       fast_i,

    output wire       xck_o,       // moves in every clock, also while this block sleeps
    output reg        bclk_o,
    output wire       lrck_o,

    output wire       fall_o,      // BCLK falls at the end of this clock
    output wire [5:0] next_slot_o, // beside fall_o: the slot that then begins

    output wire       due_o,
    output wire [9:0] rest_o
);
    localparam [4:0] SLOW_HALF = 5'd24;   // clocks
    localparam [4:0] FAST_HALF = 5'd4;

    reg  [4:0] due_q;                     // the clock of the next edge of BCLK
    reg  [5:0] slot_q;
    wire       bclk_edge = due_q == now_i[4:0];

    assign fall_o      = bclk_edge && bclk_o;
    assign next_slot_o = slot_q + 6'd1;
    assign lrck_o      = slot_q[5];
    assign xck_o       = now_i[0];
    assign due_o       = bclk_edge;
    assign rest_o      = {5'd0, due_q - now_i[4:0] - 5'd1};

    always @(posedge clk_i) begin
        if (bclk_edge) begin
            due_q  <= now_i[4:0] + (fast_i ? FAST_HALF : SLOW_HALF);
            bclk_o <= !bclk_o;
            if (bclk_o) slot_q <= next_slot_o;
        end
        if (rst_i) begin
            due_q  <= SLOW_HALF - 5'd1;   // after a reset now_i begins at 0
            bclk_o <= 1'b0;
            slot_q <= 6'd63;              // the first fall of BCLK begins a frame
        end
    end
endmodule

`default_nettype wire
