// video.v - the VGA controller and the memories that it shows
//
//   h2f_bridge --+--> picture_store ----+--> vga --> ADV7123
//                +--> character_store --+
//
// The screen's reads go before the processor's in both.

`default_nettype none

module video (
    input  wire        clk_i,           // of the beam and the pictures' memory
    input  wire        registers_clk_i,
    input  wire        cells_clk_i,     // of the characters' memory
    input  wire        rst_i,
    input  wire [29:0] now_i,

    input  wire        we_i,            // register bus, PIXEL
    input  wire [3:0]  wstrb_i,
    input  wire [11:0] waddr_i,
    input  wire [31:0] wdata_i,
    input  wire        re_i,
    input  wire        resampler_re_i,  // RESAMPLER
    input  wire        text_we_i,       // TEXT
    input  wire        text_re_i,
    input  wire [11:0] raddr_i,
    output wire [31:0] rdata_o,

    input  wire [3:0]  picture_we_i,    // full bridge: byte lanes of a word of the pictures
    input  wire [3:0]  cells_we_i,      // and of the characters
    input  wire [16:0] windex_i,
    input  wire [31:0] picture_i,
    input  wire        picture_re_i,    // both; held until rgrant_o, data one clock later
    input  wire [16:0] rindex_i,
    output wire        rgrant_o,
    output wire [31:0] picture_o,
    output wire [31:0] cells_o,
    output wire        cells_wait_o,    // the characters are being cleared

    output wire        vga_hs_no,       // ADV7123
    output wire        vga_vs_no,
    output wire        vga_blank_no,
    output wire        vga_sync_no,
    output wire [7:0]  vga_r_o,
    output wire [7:0]  vga_g_o,
    output wire [7:0]  vga_b_o,

    output wire        registers_awake_o,
    output wire        cells_awake_o,
    output wire        frame_end_o,     // wakes the registers
    output wire        cells_clear_o,   // these two wake the characters' memory
    output wire        cell_fetch_o,
    output wire [9:0]  rest_o
);
    wire        fetch, keep, cells_any, cells_clearing, enable, text_enable;
    wire [31:0] front;
    wire [10:0] cell_index;
    wire [16:0] fetch_index;

    screen_registers registers (
        .clk_i(registers_clk_i), .rst_i(rst_i), .we_i(we_i), .wstrb_i(wstrb_i), .waddr_i(waddr_i),
        .wdata_i(wdata_i), .re_i(re_i), .resampler_re_i(resampler_re_i),
        .text_we_i(text_we_i), .text_re_i(text_re_i), .raddr_i(raddr_i), .rdata_o(rdata_o),
        .frame_end_i(frame_end_o), .front_o(front), .enable_o(enable), .text_enable_o(text_enable),
        .clear_o(cells_clear_o), .clearing_i(cells_clearing), .awake_o(registers_awake_o)
    );

    vga vga_block (
        .clk_i(clk_i), .rst_i(rst_i), .now_i(now_i),
        .front_i(front), .enable_i(enable), .text_enable_i(text_enable), .frame_end_o(frame_end_o),
        .fetch_o(fetch), .keep_o(keep), .index_o(fetch_index), .word_i(picture_o),
        .cell_o(cell_fetch_o), .cell_index_o(cell_index), .cells_i(cells_o),
        .cells_any_i(cells_any),
        .vga_hs_no(vga_hs_no), .vga_vs_no(vga_vs_no), .vga_blank_no(vga_blank_no),
        .vga_sync_no(vga_sync_no), .vga_r_o(vga_r_o), .vga_g_o(vga_g_o), .vga_b_o(vga_b_o),
        .rest_o(rest_o)
    );

    picture_store pictures (
        .clk_i(clk_i), .screen_re_i(fetch), .screen_keep_i(keep), .screen_index_i(fetch_index),
        .re_i(picture_re_i), .rindex_i(rindex_i), .rgrant_o(rgrant_o), .rdata_o(picture_o),
        .we_i(picture_we_i), .windex_i(windex_i), .wdata_i(picture_i)
    );

    character_store characters (
        .clk_i(cells_clk_i), .rst_i(rst_i), .clear_i(cells_clear_o), .clearing_o(cells_clearing),
        .filling_o(cells_wait_o), .any_o(cells_any),
        .screen_re_i(cell_fetch_o), .screen_index_i(cell_index),
        .re_i(picture_re_i && rgrant_o), .rindex_i(rindex_i[10:0]), .rdata_o(cells_o),
        .we_i(cells_we_i), .windex_i(windex_i[10:0]), .wdata_i(picture_i),
        .awake_o(cells_awake_o)
    );
endmodule

`default_nettype wire
