// vga_timing.v - in the simulation: where the beam is, without a counter
//
// The beam's place in the line is computed from the number of the clock in which the line began, so
// clocks in which no register changes can be left out.  At its ports it is rtl/vga/vga_timing.v
// (tb/formal/leaps_formal.v).

`default_nettype none

module vga_timing (
    input  wire       clk_i,
    input  wire       rst_i,

    output wire [9:0] h_o,          // 0 to 799; 0 to 639 are shown
    output reg  [9:0] v_o,          // 0 to 524; 0 to 479 are shown
    output wire       line_end_o,   // last clock of a line
    output wire [9:0] v_next_o,     // the next line
    output wire       visible_o,    // on the pins from the next clock on
    output reg        hs_no,
    output reg        vs_no,        // moves with the leading edge of HS
    output reg        blank_no
);
    localparam [9:0] H_SHOWN = 640, H_FRONT = 16, H_SYNC = 96, H_TOTAL = 800;
    localparam [9:0] V_SHOWN = 480, V_FRONT = 10, V_SYNC = 2, V_TOTAL = 525;
    localparam [9:0] LATER = 3;     // edges from the beam to the pins, less one
    localparam [9:0] SHOW = LATER, HIDE = H_SHOWN + LATER, SYNC = H_SHOWN + H_FRONT + LATER,
                     SYNC_END = SYNC + H_SYNC, LAST = H_TOTAL - 1;

    // Only the low bits are used: enough for the clocks of one line.
    // verilator lint_off UNUSED
    wire [29:0] now;
    // verilator lint_on UNUSED
    clock_number number (.now_o(now));

    reg  [9:0] begun_q;             // the clock in which the line began

    assign h_o        = now[9:0] - begun_q;
    assign line_end_o = h_o == LAST;
    assign v_next_o   = v_o == V_TOTAL - 10'd1 ? 10'd0 : v_o + 10'd1;
    assign visible_o  = h_o >= SHOW && h_o < HIDE && v_o < V_SHOWN;

    wire show = h_o == SHOW && v_o < V_SHOWN;
    wire hide = h_o == HIDE && v_o < V_SHOWN;

    always @(posedge clk_i) begin
        if (show) blank_no <= 1'b1;
        if (hide) blank_no <= 1'b0;
        if (h_o == SYNC) begin
            hs_no <= 1'b0;
            vs_no <= !(v_next_o >= V_SHOWN + V_FRONT && v_next_o < V_SHOWN + V_FRONT + V_SYNC);
        end
        if (h_o == SYNC_END) hs_no <= 1'b1;
        if (line_end_o) begin
            begun_q <= now[9:0] + 10'd1;
            v_o     <= v_next_o;
        end
        if (rst_i) begin
            begun_q  <= now[9:0] + 10'd1;
            v_o      <= V_SHOWN;    // begin with the blanking: the first frame is a whole one
            hs_no    <= 1'b1;
            vs_no    <= 1'b1;
            blank_no <= 1'b0;
        end
    end

    // ---- Clocks after this one in which nothing changes ---------------------
    function [9:0] rest_until;
        input [9:0] h;              // later than h_o
        rest_until = h - h_o - 10'd1;
    endfunction

    wire [9:0] rest = h_o < HIDE && v_o < V_SHOWN ? 10'd0 : h_o < SYNC ? rest_until(SYNC)
                    : h_o < SYNC_END ? rest_until(SYNC_END) : h_o < LAST ? rest_until(LAST) : 10'd0;
endmodule

`default_nettype wire
