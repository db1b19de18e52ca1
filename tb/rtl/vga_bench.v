// vga_bench.v - the beam and the registers that it shows by, on one clock.

`default_nettype none

module vga_bench (
    input  wire        clk_i,
    input  wire        rst_i,

    input  wire        we_i,
    input  wire [3:0]  wstrb_i,
    input  wire [11:0] waddr_i,
    input  wire [31:0] wdata_i,
    input  wire        re_i,
    input  wire        resampler_re_i,
    input  wire        text_we_i,
    input  wire        text_re_i,
    input  wire [11:0] raddr_i,
    output wire [31:0] rdata_o,

    output wire        fetch_o,         // the on-chip memory
    output wire [15:0] index_o,
    input  wire        onchip_read_i,   // the processor reads it
    input  wire [31:0] word_i,
    output wire        sdram_req_o,
    output wire [23:0] sdram_index_o,
    input  wire        sdram_take_i,
    input  wire        sdram_valid_i,
    input  wire [31:0] sdram_i,
    output wire        cell_o,
    output wire [10:0] cell_index_o,
    input  wire [31:0] cells_i,
    input  wire        cells_any_i,
    output wire        clear_o,
    input  wire        clearing_i,

    output wire        vga_hs_no,
    output wire        vga_vs_no,
    output wire        vga_blank_no,
    output wire        vga_sync_no,
    output wire [7:0]  vga_r_o,
    output wire [7:0]  vga_g_o,
    output wire [7:0]  vga_b_o
);
    wire [31:0] front;
    wire [12:0] text_front;
    wire        enable, frame_end, line_end, odd, pixel, line_we;
    wire [9:0]  v_next;
    wire [8:0]  pixel_index, line_windex;
    wire [31:0] pixel_word, line_wdata;

    // No clock is left out here.
    // verilator lint_off PINCONNECTEMPTY
    screen_registers registers (
        .clk_i(clk_i), .rst_i(rst_i), .we_i(we_i), .wstrb_i(wstrb_i), .waddr_i(waddr_i),
        .wdata_i(wdata_i), .re_i(re_i), .resampler_re_i(resampler_re_i),
        .text_we_i(text_we_i), .text_re_i(text_re_i), .raddr_i(raddr_i), .rdata_o(rdata_o),
        .frame_end_i(frame_end), .front_o(front), .text_front_o(text_front),
        .enable_o(enable),
        .clear_o(clear_o), .clearing_i(clearing_i), .awake_o()
    );
    vga beam (
        .clk_i(clk_i), .rst_i(rst_i),
        .upper_i(front[1]), .enable_i(enable), .text_front_i(text_front),
        .frame_end_o(frame_end), .odd_o(odd), .line_end_o(line_end), .v_next_o(v_next),
        .pixel_o(pixel), .index_o(pixel_index), .word_i(pixel_word),
        .cell_o(cell_o), .cell_index_o(cell_index_o), .cells_i(cells_i),
        .cells_any_i(cells_any_i),
        .vga_hs_no(vga_hs_no), .vga_vs_no(vga_vs_no), .vga_blank_no(vga_blank_no),
        .vga_sync_no(vga_sync_no), .vga_r_o(vga_r_o), .vga_g_o(vga_g_o), .vga_b_o(vga_b_o)
    );
    line_buffer rows (
        .wclk_i(clk_i), .we_i(line_we), .windex_i(line_windex), .wdata_i(line_wdata),
        .rclk_i(clk_i), .re_i(pixel), .rindex_i(pixel_index), .rdata_o(pixel_word)
    );
    pixel_dma dma (
        .clk_i(clk_i), .rst_i(rst_i), .odd_i(odd), .line_end_i(line_end), .v_next_i(v_next),
        .front_i(front),
        .onchip_re_o(fetch_o), .onchip_read_i(onchip_read_i), .onchip_index_o(index_o),
        .onchip_word_i(word_i),
        .sdram_req_o(sdram_req_o), .sdram_index_o(sdram_index_o), .sdram_take_i(sdram_take_i),
        .sdram_valid_i(sdram_valid_i), .sdram_word_i(sdram_i),
        .we_o(line_we), .windex_o(line_windex), .wdata_o(line_wdata),
        .awake_o()
    );
    // verilator lint_on PINCONNECTEMPTY
endmodule

`default_nettype wire
