// vga.v - pixel DMA and VGA output: the front picture, each pixel 2 x 2, under 80 x 60 characters
//
//   clock      1             2           3               4
//   h_o        n = 4k + 1    4k + 2      4k + 3          4k + 4
//              address ----> memory ---> word --> rgb -> pins show pixel n - 1 = 4k
//
// A word holds two pixels, so it serves four clocks; each row is fetched for two lines.  A front
// address outside the two pictures shows black there.
//
// Every eighth clock a character is fetched beside the pixels; its strokes are white, the rest of
// its 8 x 8 pixels is transparent.  Codes are ASCII, bit 7 is not looked at.  Whether there are any
// characters to show is looked at between lines.
//
// Where no character can be, two clocks show one pixel: then this block sleeps in each second one,
// and between the lines.

`default_nettype none

module vga (
    input  wire        clk_i,
    input  wire        rst_i,
    input  wire [29:0] now_i,

    // The two lowest bits would split a word.
    // verilator lint_off UNUSED
    input  wire [31:0] front_i,         // address of the picture
    // verilator lint_on UNUSED
    input  wire        enable_i,
    input  wire        text_enable_i,
    output wire        frame_end_o,     // the last line has been fetched

    output wire        fetch_o,         // to the picture store; data one clock later
    output wire        keep_o,          // ... which are to stay there for one clock more
    output wire [16:0] index_o,
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
    output reg  [7:0]  vga_b_o,

    output wire [9:0]  rest_o
);
    `include "regmap.vh"
    `include "picture_index.vh"
    `include "character_font.vh"

    localparam [9:0] H_SHOWN = 10'd640, V_SHOWN = 10'd480;

    wire [9:0] h, v, timing_rest;
    wire [8:0] row_next;
    wire       line_end, visible;

    vga_timing timing (
        .clk_i(clk_i), .rst_i(rst_i), .now_i(now_i), .h_o(h), .v_o(v), .line_end_o(line_end),
        .row_next_o(row_next), .visible_o(visible), .hs_no(vga_hs_no), .vs_no(vga_vs_no),
        .blank_no(vga_blank_no), .rest_o(timing_rest)
    );

    // In these clocks of a shown line something can happen, up to where the last pixel leaves.
    reg  text_q;                         // there are characters, in this line
    wire shown = h < H_SHOWN && v < V_SHOWN;
    wire draws = h <= H_SHOWN + 10'd3 && v < V_SHOWN && (h[0] || text_q);

    assign frame_end_o = h == 10'd0 && v == V_SHOWN;
    assign rest_o      = draws && shown ? {9'd0, !text_q} : timing_rest;

    // ---- Fetch: of each four clocks, one to ask, one in the store, one to take ----
    reg  [19:0] offset_q;   // in the picture's window, of the word to fetch; bit 19: past its end
    reg         stored_q;
    reg  [31:0] word_q;
    wire        in0  = front_i[31:19] == PICTURE0_BASE[31:19];
    wire        in1  = front_i[31:19] == PICTURE1_BASE[31:19];
    wire [31:0] word = stored_q ? word_i : 32'd0;

    assign fetch_o = shown && h[1:0] == 2'd1;
    assign keep_o  = shown && h[1:0] == 2'd2;
    assign index_o = picture_index(in1, offset_q[18:0]);

    always @(posedge clk_i) begin
        if (fetch_o) begin
            stored_q <= stored(offset_q[18:0]) && !offset_q[19] && (in0 || in1) && enable_i;
            offset_q <= offset_q + 20'd4;
        end
        if (shown && h[1:0] == 2'd3) word_q <= word;
        if (line_end) offset_q <= {1'b0, front_i[18:2], 2'b00} + {1'b0, row_next, 10'd0};
    end

    // ---- Characters: asked for beside every other word, taken when it is ----
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
                cell_index_o <= {v[8:3], h[9:5]};
                lane_q       <= h[4:3];
                line_q       <= v[2:0];
            end
        end
        if (line_end) text_q <= cells_any_i && text_enable_i;
        if (rst_i) begin
            text_q    <= 1'b0;
            cell_o    <= 1'b0;
            strokes_q <= 8'd0;
        end
    end

    // ---- Pins: a pixel of the picture is two clocks long -------------------
    wire [15:0] pixel = strokes_q[0] ? 16'hffff : h[1:0] == 2'd3 ? word[15:0]
                        : h[1:0] == 2'd0 ? word_q[15:0] : word_q[31:16];

    assign vga_sync_no = 1'b0;     // no sync on green

    always @(posedge clk_i) begin
        if (draws) begin
            vga_r_o <= visible ? {pixel[15:11], pixel[15:13]} : 8'd0;
            vga_g_o <= visible ? {pixel[10:5], pixel[10:9]} : 8'd0;
            vga_b_o <= visible ? {pixel[4:0], pixel[4:2]} : 8'd0;
        end
        if (rst_i) {vga_r_o, vga_g_o, vga_b_o} <= 24'd0;
    end
endmodule

`default_nettype wire
