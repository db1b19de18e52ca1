// vga.v - in the simulation: rtl/vga/vga.v, but what does not change a pin is left out
//
// Without characters a pixel lasts two clocks, so it sleeps in every second clock, between the
// lines, and for each block of 16 pixels that equal the pixel before them (line_buffer.v).  Of this
// file and of rtl/vga/vga.v the same is proved: the pins show every pixel of a picture without
// characters (tb/formal/vga_formal.v).

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

    // Only in these clocks of a shown line can anything change: up to the end of the last pixel.
    reg  text_q;                         // there are characters, in this line
    wire shown = h < H_SHOWN && v < V_SHOWN;
    wire draws = h <= H_SHOWN + 10'd3 && v < V_SHOWN && (h[0] || text_q);

    assign odd_o       = h[0];
    assign frame_end_o = h == 10'd0 && v == V_SHOWN;
    wire [9:0] timing_rest;
    beam_rest rests (.rest_o(timing_rest));
    wire [9:0] rest = flat ? {5'd0, 5'd0 - h[4:0]} : draws && shown ? {9'd0, !text_q}
                      : timing_rest;

    // ---- Pixels -----------------------------------------------------------
    // A block of 16 begins; whether it is flat, and whether that matters.
    wire        flat_i;
    flat_block flat_blocks (.flat_o(flat_i));
    reg         flat_q;
    wire        begins = h[4:0] == 5'd1;
    wire        flat   = shown && (begins ? flat_i && !text_q && !upper_i : flat_q);

    wire [8:0]  place = h[9:1] + {8'd0, upper_i};    // the pixel's half word in the row
    reg         half_q;
    reg  [15:0] pixel_q;                             // in the clock before
    wire [15:0] pixel = !h[0] ? pixel_q : half_q ? word_i[31:16] : word_i[15:0];

    assign pixel_o = shown && h[0] && !flat;
    assign index_o = {v[1], place[8:1]};

    always @(posedge clk_i) begin
        if (pixel_o) half_q <= place[0];
        if (draws && h[0]) pixel_q <= pixel;
        if (begins) flat_q <= flat;
        if (rst_i) flat_q <= 1'b0;
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
        if (draws && text_q) begin
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
        if (draws && !flat_q) begin
            vga_r_o <= visible ? {colour[15:11], colour[15:13]} : 8'd0;
            vga_g_o <= visible ? {colour[10:5], colour[10:9]} : 8'd0;
            vga_b_o <= visible ? {colour[4:0], colour[4:2]} : 8'd0;
        end
        if (rst_i) {vga_r_o, vga_g_o, vga_b_o} <= 24'd0;
    end
endmodule

`default_nettype wire
