// vga_formal.v - every pixel on the pins is the front picture's, in time; blanking is black.
//
// By 5-step induction over the VGA output, the pictures' store and a memory that holds a pattern.
// The beam, the processor's reads, the front address and whether it is shown are free.

`default_nettype none

// In place of the pictures' memory: each word holds its own index, and so tells who asked for it.
module picture_memory (
    input  wire        clk_i,
    input  wire [3:0]  we_i,
    input  wire [16:0] windex_i,
    input  wire [31:0] wdata_i,
    input  wire        re_i,
    input  wire [16:0] rindex_i,
    output reg  [31:0] rdata_o
);
    always @(posedge clk_i) if (re_i) rdata_o <= {~rindex_i[15:0], rindex_i[16:1]};
endmodule

module vga_formal (
    input wire        clk_i,
    input wire        rst_i,
    input wire [31:0] front_i,
    input wire        enable_i,
    input wire        re_i,          // the processor's, of the store
    input wire [16:0] rindex_i
);
    `include "regmap.vh"
    `include "picture_index.vh"

    wire        screen_re, screen_keep, grant, blank_n;
    wire [16:0] screen_index;
    wire [31:0] word;
    wire [7:0]  r, g, b;
    reg  [29:0] now_q;

    vga dut (
        .clk_i(clk_i), .rst_i(rst_i), .now_i(now_q), .front_i(front_i), .enable_i(enable_i),
        .text_enable_i(1'b0), .frame_end_o(),
        .fetch_o(screen_re), .keep_o(screen_keep), .index_o(screen_index), .word_i(word),
        .cell_o(), .cell_index_o(), .cells_i(32'd0), .cells_any_i(1'b0),
        .vga_hs_no(), .vga_vs_no(), .vga_blank_no(blank_n), .vga_sync_no(),
        .vga_r_o(r), .vga_g_o(g), .vga_b_o(b), .rest_o()
    );

    picture_store store (
        .clk_i(clk_i), .screen_re_i(screen_re), .screen_keep_i(screen_keep),
        .screen_index_i(screen_index), .re_i(re_i), .rindex_i(rindex_i), .rgrant_o(grant),
        .rdata_o(word), .we_i(4'd0), .windex_i(17'd0), .wdata_i(32'd0)
    );

    // ---- The reference: what each pixel should be, four clocks ahead of the pins ----
    wire [9:0]  dut__h, dut__v;

    reg         live = 1'b0;
    reg  [18:0] line_q;                      // where in the pictures' window this line begins
    reg         past_q;                      // ... and whether it begins past its end
    wire        shown = dut__h < 10'd640 && dut__v < 10'd480;
    wire [9:0]  row_next = dut__v == 10'd524 ? 10'd0 : (dut__v + 10'd1) >> 1;
    wire [19:0] place = {past_q, line_q} + {10'd0, dut__h[9:2], 2'd0};
    wire        in1  = front_i[31:19] == PICTURE1_BASE[31:19];
    wire        in0  = front_i[31:19] == PICTURE0_BASE[31:19];
    wire        in_picture = enable_i && (in0 || in1) && !place[19] && stored(place[18:0]);
    wire [16:0] index = picture_index(in1, place[18:0]);

    reg  [31:0] word1_q, word2_q, word3_q;
    reg  [3:0]  shown_q, odd_q;              // of 1 to 4 clocks before

    always @(posedge clk_i) begin
        live    <= 1'b1;
        now_q   <= rst_i ? 30'd0 : now_q + 30'd1;
        if (dut__h == 10'd799)
            {past_q, line_q} <= {1'b0, front_i[18:2], 2'd0} + {row_next, 10'd0};
        if (shown && dut__h[1:0] == 2'd1)
            word1_q <= in_picture ? {~index[15:0], index[16:1]} : 32'd0;
        word2_q <= word1_q;
        word3_q <= word2_q;
        shown_q <= rst_i ? 4'd0 : {shown_q[2:0], shown};
        odd_q   <= {odd_q[2:0], dut__h[1]};
    end
    always @(*) if (!live) assume (rst_i);

    wire [15:0] pixel = odd_q[3] ? word3_q[31:16] : word3_q[15:0];
    wire [23:0] rgb = {pixel[15:11], pixel[15:13], pixel[10:5], pixel[10:9], pixel[4:0],
                       pixel[4:2]};

    always @(*) if (live) begin
        a_blank:             assert (blank_n == shown_q[3]);
        a_blanking_is_black: assert (blank_n || {r, g, b} == 24'd0);
        a_never_late:        assert (!blank_n || {r, g, b} == rgb);
        a_screen_goes_first: assert (!(screen_re && grant));
    end

    // ---- Invariants: the beam is in its frame; the fetch is where the line and the beam are ----
    wire [19:0] dut__offset_q;
    wire        dut__text_q;
    wire [7:0]  dut__strokes_q;
    wire [9:0]  done = dut__h > 10'd640 ? 10'd640 : (dut__h + 10'd2) & ~10'd3;
    always @(*) if (live) begin
        i_text:   assert (!dut__text_q && dut__strokes_q == 8'd0);
        i_beam:   assert (dut__h < 10'd800 && dut__v < 10'd525);
        i_offset: assert (dut__v >= 10'd480
                          || dut__offset_q == {past_q, line_q} + {10'd0, done});
    end
endmodule

`default_nettype wire
