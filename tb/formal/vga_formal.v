// vga_formal.v - every pixel on the pins is the front picture's, in time; blanking is black.
//
// From five clocks after a reset on, by 8-step induction over the VGA output, the pictures' store
// and a memory that holds a pattern.  The beam, the bus, the processor's reads and the front
// address are free.

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
    input wire        we_i,
    input wire [3:0]  wstrb_i,
    input wire [11:0] waddr_i,
    input wire [31:0] wdata_i,
    input wire        re_i,          // the processor's, of the store
    input wire [16:0] rindex_i
);
    `include "regmap.vh"
    `include "picture_index.vh"

    wire        screen_re, grant, blank_n;
    wire [16:0] screen_index;
    wire [31:0] word;
    wire [7:0]  r, g, b;

    vga dut (
        .clk_i(clk_i), .rst_i(rst_i), .we_i(we_i), .wstrb_i(wstrb_i), .waddr_i(waddr_i),
        .wdata_i(wdata_i), .re_i(1'b0), .resampler_re_i(1'b0),
        .text_we_i(1'b0), .text_re_i(1'b0), .raddr_i(12'd0), .rdata_o(),
        .fetch_o(screen_re), .index_o(screen_index), .word_i(word),
        .cell_o(), .cell_index_o(), .cells_i(32'd0), .cells_any_i(1'b0), .clear_o(),
        .clearing_i(1'b0),
        .vga_clk_o(), .vga_hs_no(), .vga_vs_no(), .vga_blank_no(blank_n), .vga_sync_no(),
        .vga_r_o(r), .vga_g_o(g), .vga_b_o(b)
    );

    picture_store store (
        .clk_i(clk_i), .screen_re_i(screen_re), .screen_index_i(screen_index), .re_i(re_i),
        .rindex_i(rindex_i), .rgrant_o(grant), .rdata_o(word), .we_i(4'd0), .windex_i(17'd0),
        .wdata_i(32'd0)
    );

    // ---- The reference: what each pixel should be, four clocks ahead of the pins ----
    wire [9:0]  dut__h, dut__v;
    wire [31:0] dut__front;
    wire        dut__enable;

    reg         live = 1'b0;
    reg  [2:0]  age_q = 3'd0;                // clocks since the last reset
    reg  [18:0] line_q;                      // where in the pictures' window this line begins
    reg         past_q;                      // ... and whether it begins past its end
    wire        shown = dut__h < 10'd640 && dut__v < 10'd480;
    wire [9:0]  row_next = dut__v == 10'd524 ? 10'd0 : (dut__v + 10'd1) >> 1;
    wire [19:0] place = {past_q, line_q} + {10'd0, dut__h[9:2], 2'd0};
    wire        in1  = dut__front[31:19] == PICTURE1_BASE[31:19];
    wire        in0  = dut__front[31:19] == PICTURE0_BASE[31:19];
    wire        in_picture = dut__enable && (in0 || in1) && !place[19] && stored(place[18:0]);
    wire [16:0] index = picture_index(in1, place[18:0]);

    reg  [31:0] word1_q, word2_q, word3_q, word4_q;
    reg  [3:0]  shown_q, odd_q;              // of 1 to 4 clocks before

    always @(posedge clk_i) begin
        live    <= 1'b1;
        age_q   <= rst_i ? 3'd0 : age_q == 3'd7 ? 3'd7 : age_q + 3'd1;
        if (dut__h == 10'd799)
            {past_q, line_q} <= {1'b0, dut__front[18:2], 2'd0} + {row_next, 10'd0};
        if (shown && dut__h[1:0] == 2'd0)
            word1_q <= in_picture ? {~index[15:0], index[16:1]} : 32'd0;
        word2_q <= word1_q;
        word3_q <= word2_q;
        word4_q <= word3_q;
        shown_q <= {shown_q[2:0], shown};
        odd_q   <= {odd_q[2:0], dut__h[1]};
    end
    always @(*) if (!live) assume (rst_i);

    wire [15:0] pixel = odd_q[3] ? word4_q[31:16] : word4_q[15:0];
    wire [23:0] rgb = {pixel[15:11], pixel[15:13], pixel[10:5], pixel[10:9], pixel[4:0],
                       pixel[4:2]};

    always @(*) if (age_q > 3'd4) begin
        a_blank:             assert (blank_n == shown_q[3]);
        a_blanking_is_black: assert (blank_n || {r, g, b} == 24'd0);
        a_never_late:        assert (!blank_n || {r, g, b} == rgb);
        a_screen_goes_first: assert (!(screen_re && grant));
    end

    // ---- Invariants: the beam is in its frame; the fetch is where the line and the beam are ----
    wire [19:0] dut__offset_q;
    wire        dut__text_q;
    wire [7:0]  dut__strokes_q;
    wire [9:0]  done = dut__h > 10'd640 ? 10'd640 : (dut__h + 10'd3) & ~10'd3;
    always @(*) if (live) begin
        i_text:   assert (!dut__text_q && dut__strokes_q == 8'd0);
        i_beam:   assert (dut__h < 10'd800 && dut__v < 10'd525);
        i_offset: assert (dut__v >= 10'd480
                          || dut__offset_q == {past_q, line_q} + {10'd0, done});
    end
endmodule

`default_nettype wire
