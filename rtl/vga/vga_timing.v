// vga_timing.v - 640 x 480 at 60 Hz: where the beam is (VESA DMT; 25 MHz / (800 * 525) = 59.52 Hz)
//
//   pixels:  |<-- 640 shown -->|< 16 >|<-- 96 HS low -->|<-- 48 -->|   800 per line
//   lines:   |<-- 480 shown -->|< 10 >|<--  2 VS low -->|<-- 33 -->|   525 per frame
//
// The pins follow the beam four clocks later, the time that a pixel takes to reach its pins.
//
// In the simulation sim/fpga/vga_timing.v takes its place.

`default_nettype none

module vga_timing (
    input  wire       clk_i,
    input  wire       rst_i,

    output reg  [9:0] h_o,          // 0 to 799; 0 to 639 are shown
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
        h_o <= line_end_o ? 10'd0 : h_o + 10'd1;
        if (line_end_o) v_o <= v_next_o;
        if (rst_i) begin
            h_o      <= 10'd0;
            v_o      <= V_SHOWN;    // begin with the blanking: the first frame is a whole one
            hs_no    <= 1'b1;
            vs_no    <= 1'b1;
            blank_no <= 1'b0;
        end
    end
endmodule

`default_nettype wire
