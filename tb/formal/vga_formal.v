// vga_formal.v - every pixel on the pins is the line buffer's, in time; blanking is black.
//
// By 5-step induction.  The beam and the content of the line buffer are unconstrained, within
// their own rules.  Two inputs are constant during a line: whether the picture is shown, and in
// which half of a word it begins.
//
// With TWIN it is said of the simulation's file, and which blocks are flat is unconstrained, too.

`default_nettype none

`ifdef TWIN
// Whether a block is flat: as the harness bounds it.
module flat_block (output wire flat_o);
    (* anyseq *) reg flat;
    assign flat_o = flat;
endmodule

module beam_rest (output wire [9:0] rest_o);
    (* anyseq *) reg [9:0] rest;
    assign rest_o = rest;
endmodule
`endif

module vga_formal (
    input wire        clk_i,
    input wire        rst_i,
    input wire        enable_i,
    input wire        upper_i,
    input wire [31:0] free_i,        // the next word of the line
    input wire [31:0] other_i        // any other word
);
    wire       pixel, blank_n, frame_end, odd;
    wire [8:0] index;
    wire [7:0] r, g, b;
    reg [31:0] rdata_q;

`ifdef TWIN
    vga_twin dut (
`else
    vga dut (
`endif
        .clk_i(clk_i), .rst_i(rst_i), .upper_i(upper_i), .enable_i(enable_i),
        .text_front_i(13'd0), .frame_end_o(frame_end), .odd_o(odd), .line_end_o(), .v_next_o(),
        .pixel_o(pixel), .index_o(index), .word_i(rdata_q),
        .cell_o(), .cell_index_o(), .cells_i(32'd0), .cells_any_i(1'b0),
        .vga_hs_no(), .vga_vs_no(), .vga_blank_no(blank_n), .vga_sync_no(),
        .vga_r_o(r), .vga_g_o(g), .vga_b_o(b)
    );

    // ---- The line buffer: its words come up one by one, as the beam moves on ----
    wire [9:0]  dut__h, dut__v;
`ifdef TWIN
    wire        dut__flat_i;             // of the block that begins
`endif

    reg         live = 1'b0;
    reg         enable_q, upper_q, flat_q;
    reg  [31:0] word_q;
    wire        shown = dut__h < 10'd640 && dut__v < 10'd480;
    wire [8:0]  place = dut__h[9:1] + {8'd0, upper_i};    // of the pixel, among half words
    wire        fresh = !place[0] || dut__h[9:1] == 9'd0;
    wire [31:0] word  = fresh ? free_i : word_q;
    wire [15:0] half  = place[0] ? word[31:16] : word[15:0];
    wire [8:0]  here  = {dut__v[1], place[8:1]};
    wire        begins = shown && dut__h[4:0] == 5'd1;
`ifdef TWIN
    wire        flat  = begins ? dut__flat_i && !upper_i : flat_q;
`else
    wire        flat  = 1'b0;
`endif

    always @(posedge clk_i) begin
        live     <= 1'b1;
        enable_q <= enable_i;
        upper_q  <= upper_i;
        if (shown && dut__h[0]) word_q <= word;
        if (pixel) rdata_q <= index == here ? word : other_i;
        if (dut__h[4:0] == 5'd1) flat_q <= begins && flat;
        if (rst_i) flat_q <= 1'b0;
    end
    always @(*) begin
        if (!live) assume (rst_i);
        if (dut__h != 10'd0) assume (enable_i == enable_q && upper_i == upper_q);
        // A flat block equals the pixel before it, so the first block is not flat.
        if (begins && dut__h < 10'd32) assume (!flat);
        if (shown && dut__h[0] && flat) assume (word == {pixel1_q, pixel1_q});
    end

    // ---- The reference: what is on the pins ----
    reg  [15:0] pixel1_q, pixel2_q, pixel3_q; // of 1 to 3 clocks before, each for two clocks
    reg  [3:0]  shown_q;                      // of 1 to 4 clocks before
    reg  [2:0]  flats_q;

    always @(posedge clk_i) begin
        if (shown && dut__h[0]) pixel1_q <= half;
        pixel2_q <= pixel1_q;
        pixel3_q <= pixel2_q;
        shown_q  <= rst_i ? 4'd0 : {shown_q[2:0], shown};
        flats_q  <= {flats_q[1:0], flat};
    end

    function [23:0] rgb;
        input [15:0] pixel;
        rgb = {pixel[15:11], pixel[15:13], pixel[10:5], pixel[10:9], pixel[4:0], pixel[4:2]};
    endfunction
    wire right = {r, g, b} == (enable_i ? rgb(pixel3_q) : 24'd0);

    always @(*) if (live) begin
        a_blank:             assert (blank_n == shown_q[3]);
        a_blanking_is_black: assert (blank_n || {r, g, b} == 24'd0);
        a_pixel:             assert (!blank_n || flats_q[2] || right);
        a_flat_pixel:        assert (!blank_n || !flats_q[2] || right);
        a_fetch:             assert (odd == dut__h[0] && frame_end
                                     == (dut__h == 10'd0 && dut__v == 10'd480));
    end

    // ---- Invariants: the beam is in its frame; in a flat block all is as the pixel before ----
    wire        dut__text_q;
    wire [7:0]  dut__strokes_q;
    always @(*) if (live) begin
        i_text:   assert (!dut__text_q && dut__strokes_q == 8'd0);
        i_beam:   assert (dut__h < 10'd800 && dut__v < 10'd525);
    end
`ifdef TWIN
    wire        dut__half_q, dut__flat_q;
    wire [15:0] dut__pixel_q;
    always @(*) if (live) begin
        i_flat:   assert (dut__flat_q == flat_q);
        i_place:  assert (!flat_q || (dut__h >= 10'd34 && dut__h <= 10'd641 && dut__v < 10'd480
                                      && !upper_q));
        i_kept:   assert (!flat_q || (dut__pixel_q == pixel1_q && pixel1_q == pixel2_q
                                      && pixel2_q == pixel3_q));
        i_read:   assert (!flat_q || pixel1_q == (dut__half_q ? rdata_q[31:16] : rdata_q[15:0]));
        i_pins:   assert (!flat_q || {r, g, b} == (enable_i ? rgb(pixel1_q) : 24'd0));
    end
`endif
endmodule

`default_nettype wire
