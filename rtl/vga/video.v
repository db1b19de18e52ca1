// video.v - the VGA controller and the memories that it shows
//
//   h2f_bridge --+--> onchip_store --+--> pixel_dma --> line_buffer --+--> vga --> ADV7123
//                |    SDRAM ---------+                                |
//                +--> character_store --------------------------------+
//
// In all of them the screen's reads have priority over the processor's.

`default_nettype none

module video (
    input  wire        clk_i,           // of the beam
    input  wire        registers_clk_i,
    input  wire        memory_clk_i,    // of the on-chip memory and the picture's fetch
    input  wire        cells_clk_i,     // of the characters' memory
    input  wire        rst_i,

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

    input  wire [3:0]  onchip_we_i,     // full bridge: byte lanes of a word of the on-chip memory
    input  wire [3:0]  cells_we_i,      // and of the characters
    input  wire [15:0] windex_i,
    input  wire [31:0] onchip_i,
    input  wire        onchip_re_i,     // both; held until rgrant_o, data one clock later
    input  wire [15:0] rindex_i,
    output wire        rgrant_o,
    output wire [31:0] onchip_o,
    output wire [31:0] cells_o,
    output wire        cells_wait_o,    // the characters are being cleared

    output wire        sdram_req_o,     // the screen's reads of the SDRAM
    output wire [23:0] sdram_index_o,
    input  wire        sdram_take_i,
    input  wire        sdram_valid_i,
    input  wire [31:0] sdram_i,

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
    output wire        fetch_awake_o
);
    wire        cells_any, cells_clearing, enable;
    wire [31:0] front;
    wire [12:0] text_front;
    wire [10:0] cell_index;

    screen_registers registers (
        .clk_i(registers_clk_i), .rst_i(rst_i), .we_i(we_i), .wstrb_i(wstrb_i), .waddr_i(waddr_i),
        .wdata_i(wdata_i), .re_i(re_i), .resampler_re_i(resampler_re_i),
        .text_we_i(text_we_i), .text_re_i(text_re_i), .raddr_i(raddr_i), .rdata_o(rdata_o),
        .frame_end_i(frame_end_o), .front_o(front), .text_front_o(text_front), .enable_o(enable),
        .clear_o(cells_clear_o), .clearing_i(cells_clearing), .awake_o(registers_awake_o)
    );

    // ---- The beam and the rows of the picture -----------------------------
    wire        odd, pixel, line_we, line_end;
    wire [8:0]  pixel_index, line_windex;
    wire [9:0]  v_next;
    wire [31:0] pixel_word, line_wdata;

    vga vga_block (
        .clk_i(clk_i), .rst_i(rst_i),
        .upper_i(front[1]), .enable_i(enable), .text_front_i(text_front),
        .frame_end_o(frame_end_o), .odd_o(odd), .line_end_o(line_end), .v_next_o(v_next),
        .pixel_o(pixel), .index_o(pixel_index), .word_i(pixel_word),
        .cell_o(cell_fetch_o), .cell_index_o(cell_index), .cells_i(cells_o),
        .cells_any_i(cells_any),
        .vga_hs_no(vga_hs_no), .vga_vs_no(vga_vs_no), .vga_blank_no(vga_blank_no),
        .vga_sync_no(vga_sync_no), .vga_r_o(vga_r_o), .vga_g_o(vga_g_o), .vga_b_o(vga_b_o)
    );

    line_buffer rows (
        .wclk_i(memory_clk_i), .we_i(line_we), .windex_i(line_windex), .wdata_i(line_wdata),
        .rclk_i(clk_i), .re_i(pixel), .rindex_i(pixel_index), .rdata_o(pixel_word)
    );

    wire        fetch, grant;
    wire [15:0] fetch_index;

    pixel_dma dma (
        .clk_i(memory_clk_i), .rst_i(rst_i), .odd_i(odd), .line_end_i(line_end), .v_next_i(v_next),
        .front_i(front),
        .onchip_re_o(fetch), .onchip_read_i(onchip_re_i && rgrant_o),
        .onchip_index_o(fetch_index), .onchip_word_i(onchip_o),
        .sdram_req_o(sdram_req_o), .sdram_index_o(sdram_index_o), .sdram_take_i(sdram_take_i),
        .sdram_valid_i(sdram_valid_i), .sdram_word_i(sdram_i),
        .we_o(line_we), .windex_o(line_windex), .wdata_o(line_wdata),
        .awake_o(fetch_awake_o)
    );

    // ---- Memories ---------------------------------------------------------
    assign rgrant_o = grant && !cell_fetch_o;

    onchip_store onchip (
        .clk_i(memory_clk_i), .screen_re_i(fetch), .screen_index_i(fetch_index),
        .re_i(onchip_re_i && !cell_fetch_o), .rindex_i(rindex_i), .rgrant_o(grant),
        .rdata_o(onchip_o),
        .we_i(onchip_we_i), .windex_i(windex_i), .wdata_i(onchip_i)
    );

    character_store characters (
        .clk_i(cells_clk_i), .rst_i(rst_i), .clear_i(cells_clear_o), .clearing_o(cells_clearing),
        .filling_o(cells_wait_o), .any_o(cells_any),
        .screen_re_i(cell_fetch_o), .screen_index_i(cell_index),
        .re_i(onchip_re_i && rgrant_o), .rindex_i(rindex_i[10:0]), .rdata_o(cells_o),
        .we_i(cells_we_i), .windex_i(windex_i[10:0]), .wdata_i(onchip_i),
        .awake_o(cells_awake_o)
    );
endmodule

`default_nettype wire
