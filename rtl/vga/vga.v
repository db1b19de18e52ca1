// vga.v - VGA output: the front picture, each pixel 2 x 2, under 80 x 60 characters
//
//   clock      1              2           3               4
//   h_o        n = 2x + 1     2x + 2      2x + 3          2x + 4
//              address ----> line buffer ------> rgb ---> pins show pixel x, for two clocks
//
// By then pixel_dma.v has fetched the row.
//
// Every eighth clock a character is fetched; its strokes are white, the rest of its 8 x 8 pixels is
// transparent.  Codes are ASCII; bit 7 is ignored.  Whether there are any characters to show is
// sampled between lines.
//
// In the simulation sim/fpga/vga.v takes its place, which leaves out what does not change a pin.

`default_nettype none

module vga (
    input  wire        clk_i,
    input  wire        rst_i,

    input  wire        upper_i,         // the picture begins in the upper half of a word
    input  wire        enable_i,
    input  wire [12:0] text_front_i,    // where the characters begin in their memory
    output wire        frame_end_o,     // the last line has been fetched

    output wire        odd_o,           // an odd clock of the line, for the picture's fetch
    output wire        line_end_o,
    output wire [9:0]  v_next_o,
    output wire        pixel_o,         // to the line buffer; data one clock later
    output wire [8:0]  index_o,
    input  wire [31:0] word_i,

    output reg         cell_o,          // to the character store; data one clock later
    output reg  [10:0] cell_index_o,
    input  wire [31:0] cells_i,
    input  wire        cells_any_i,     // some character is not a blank

    output wire        vga_hs_no,       // ADV7123; its clock is the inverted clk_i
    output wire        vga_vs_no,
    output wire        vga_blank_no,
    output wire        vga_sync_no,
    output reg  [7:0]  vga_r_o,
    output reg  [7:0]  vga_g_o,
    output reg  [7:0]  vga_b_o
);
    `include "character_font.vh"

    localparam [9:0] H_SHOWN = 10'd640, V_SHOWN = 10'd480;

    wire [9:0] h, v;
    wire       visible;

    vga_timing timing (
        .clk_i(clk_i), .rst_i(rst_i), .h_o(h), .v_o(v), .line_end_o(line_end_o),
        .v_next_o(v_next_o), .visible_o(visible), .hs_no(vga_hs_no), .vs_no(vga_vs_no),
        .blank_no(vga_blank_no)
    );

    reg  text_q;                         // there are characters, in this line
    wire shown = h < H_SHOWN && v < V_SHOWN;

    assign odd_o       = h[0];
    assign frame_end_o = h == 10'd0 && v == V_SHOWN;

    // ---- Pixels -----------------------------------------------------------
    wire [8:0]  place = h[9:1] + {8'd0, upper_i};    // the pixel's half word in the row
    reg         half_q;
    reg  [15:0] pixel_q;                             // in the clock before
    wire [15:0] pixel = !h[0] ? pixel_q : half_q ? word_i[31:16] : word_i[15:0];

    assign pixel_o = shown && h[0];
    assign index_o = {v[1], place[8:1]};

    always @(posedge clk_i) begin
        if (pixel_o) half_q <= place[0];
        pixel_q <= pixel;
    end

    // ---- Characters: asked for in every eighth clock --------------------------
    wire [12:0] place_of_cell = text_front_i + {v[8:3], h[9:3]};
    reg  [1:0]  lane_q;     // of the character in its word
    reg  [2:0]  line_q;     // of the character's eight
    reg  [7:0]  strokes_q;  // bit 0 now, bit 1 in the next clock; 0 without text_q
    wire [6:0]  code = cells_i[{lane_q, 3'd0} +: 7];

    function [7:0] line_of;
        input [63:0] pixels;
        input [2:0]  line;
        line_of = pixels[{line, 3'd0} +: 8];
    endfunction

    always @(posedge clk_i) begin
        if (text_q) begin
            strokes_q <= shown && h[2:0] == 3'd2 ? line_of(letter(code), line_q)
                         : {1'b0, strokes_q[7:1]};
            cell_o    <= 1'b0;
            if (shown && h[2:0] == 3'd0) begin
                cell_o       <= 1'b1;
                cell_index_o <= place_of_cell[12:2];
                lane_q       <= place_of_cell[1:0];
                line_q       <= v[2:0];
            end
        end
        if (line_end_o) text_q <= cells_any_i && enable_i;
        if (rst_i) begin
            text_q    <= 1'b0;
            cell_o    <= 1'b0;
            strokes_q <= 8'd0;
        end
    end

    // ---- Pins: a pixel of the picture is two clocks long -------------------
    wire [15:0] colour = !enable_i ? 16'd0 : strokes_q[0] ? 16'hffff : pixel;

    assign vga_sync_no = 1'b0;     // no sync on green

    always @(posedge clk_i) begin
        vga_r_o <= visible ? {colour[15:11], colour[15:13]} : 8'd0;
        vga_g_o <= visible ? {colour[10:5], colour[10:9]} : 8'd0;
        vga_b_o <= visible ? {colour[4:0], colour[4:2]} : 8'd0;
        if (rst_i) {vga_r_o, vga_g_o, vga_b_o} <= 24'd0;
    end
endmodule

`default_nettype wire
