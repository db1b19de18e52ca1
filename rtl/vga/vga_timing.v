// vga_timing.v - 640 x 480 at 60 Hz: where the beam is (VESA DMT; 25 MHz / (800 * 525) = 59.52 Hz)
//
//   pixels:  |<-- 640 shown -->|< 16 >|<-- 96 HS low -->|<-- 48 -->|   800 a line
//   lines:   |<-- 480 shown -->|< 10 >|<--  2 VS low -->|<-- 33 -->|   525 a frame

`default_nettype none

module vga_timing (
    input  wire       clk_i,        // the pixel clock, 25 MHz
    input  wire       rst_i,

    output reg  [9:0] h_o,          // 0 to 799; 0 to 639 are shown
    output reg  [9:0] v_o,          // 0 to 524; 0 to 479 are shown
    output wire       line_end_o,   // last clock of a line
    output wire [8:0] row_next_o,   // row of the picture that the next line shows, if it is shown
    output wire       hs_no,
    output reg        vs_no,        // moves with the leading edge of HS
    output wire       shown_o
);
    localparam [9:0] H_SHOWN = 640, H_FRONT = 16, H_SYNC = 96, H_TOTAL = 800;
    localparam [9:0] V_SHOWN = 480, V_FRONT = 10, V_SYNC = 2, V_TOTAL = 525;

    wire [9:0] v_next = v_o == V_TOTAL - 10'd1 ? 10'd0 : v_o + 10'd1;

    assign line_end_o = h_o == H_TOTAL - 10'd1;
    assign row_next_o = v_next[9:1];

    always @(posedge clk_i) begin
        h_o <= line_end_o ? 10'd0 : h_o + 10'd1;
        if (line_end_o) v_o <= v_next;
        if (h_o == H_SHOWN + H_FRONT - 10'd1)
            vs_no <= !(v_next >= V_SHOWN + V_FRONT && v_next < V_SHOWN + V_FRONT + V_SYNC);
        if (rst_i) begin
            h_o   <= 10'd0;
            v_o   <= V_SHOWN;   // begin with the blanking: the first frame is a whole one
            vs_no <= 1'b1;
        end
    end

    assign hs_no   = !(h_o >= H_SHOWN + H_FRONT && h_o < H_SHOWN + H_FRONT + H_SYNC);
    assign shown_o = h_o < H_SHOWN && v_o < V_SHOWN;
endmodule

`default_nettype wire
