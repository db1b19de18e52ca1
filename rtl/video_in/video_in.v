// video_in.v - the DE1-SoC Computer's video-in: the camera's picture into a buffer in the memory
//
//                               clk_td_i | clk_i
//   TD_DATA --> video_capture --> dual_clock_fifo --> video_writer --> memories
//                     ^                                    ^
//               EDGE_DETECTION                          VIDEO_IN
//
//   +0 BUFFER      where pictures go; a write of any value asks for a swap with BACK_BUFFER, which
//   +4 BACK_BUFFER takes place when the next picture begins, before its first word
//   +8 RESOLUTION  320 x 240
//   +C STATUS      EN bit 2: 1 = pictures come in, 59.94 per second; 0 = the buffer stays as it is
//
//   EDGE_DETECTION +0 CONTROL  bit 0: 1 = the picture's edges instead of the picture
//
// After a write of EN = 1 the next field begins a picture.  A write of EN = 0 stops at once, even
// in the middle of a row.
//
// Source: the DE1-SoC Computer's video-in subsystem: each field is a picture, X-Y addressing alone,
// off after a reset.

`default_nettype none

module video_in (
    input  wire        clk_i,
    input  wire        rst_i,
    input  wire        clk_td_i,          // 27 MHz, the decoder's, asynchronous
    input  wire        rst_td_i,
    input  wire [7:0]  td_data_i,         // of clk_td_i

    input  wire        we_i,              // register bus, VIDEO_IN
    input  wire        edges_we_i,        // EDGE_DETECTION
    input  wire [3:0]  wstrb_i,
    input  wire [11:0] waddr_i,
    input  wire [31:0] wdata_i,
    input  wire        re_i,
    input  wire        edges_re_i,
    input  wire [11:0] raddr_i,
    output wire [31:0] rdata_o,

    output wire        onchip_req_o,      // as in video_writer.v
    input  wire        onchip_take_i,
    output wire        sdram_req_o,
    input  wire        sdram_take_i,
    output wire [23:0] index_o,
    output wire [31:0] wdata_o,

    output wire        awake_o,
    output wire        td_awake_o         // clk_td_i is needed
);
    `include "regmap.vh"

    // ---- Registers --------------------------------------------------------
    wire [31:0] buffer, dma_rdata;
    wire        enable, picture_begin, dma_awake;
    reg         edges_q, edges_rdata_q;

    pixel_registers #(
        .BUFFER(VIDEO_IN_BUFFER_RESET), .RESOLUTION(VIDEO_IN_RESOLUTION_RESET),
        .STATUS(VIDEO_IN_STATUS_RESET)
    ) dma (
        .clk_i(clk_i), .rst_i(rst_i),
        .we_i(we_i), .wstrb_i(wstrb_i), .waddr_i(waddr_i), .wdata_i(wdata_i),
        .re_i(re_i), .resampler_re_i(1'b0), .raddr_i(raddr_i), .rdata_o(dma_rdata),
        .swap_i(picture_begin), .front_o(buffer), .enable_o(enable), .awake_o(dma_awake)
    );

    assign rdata_o = dma_rdata | {31'd0, edges_rdata_q};
    always @(posedge clk_i) begin
        edges_rdata_q <= edges_re_i && raddr_i[3:0] == EDGE_DETECTION_CONTROL[3:0] && edges_q;
        if (edges_we_i && waddr_i[3:0] == EDGE_DETECTION_CONTROL[3:0] && wstrb_i[0])
            edges_q <= wdata_i[EDGE_DETECTION_CONTROL_ON_LSB];
        if (rst_i) edges_q <= EDGE_DETECTION_CONTROL_RESET[EDGE_DETECTION_CONTROL_ON_LSB];
    end

    // ---- Capture, and into the memory -------------------------------------
    wire        push, none, capture_awake, sent_awake, come_awake, writer_awake;
    wire [33:0] captured, word;

    // Its clock may be stopped while enable is low; the other switch is low then too, since nobody
    // would see it move.
    video_capture capture (
        .clk_i(clk_td_i), .enable_i(enable), .edges_i(enable && edges_q), .data_i(td_data_i),
        .push_o(push), .word_o(captured), .awake_o(capture_awake)
    );
    // It is not full: a word is taken at once, and the next comes 296 ns later.
    // verilator lint_off PINCONNECTEMPTY
    dual_clock_fifo #(.WIDTH(34)) crossing (
        .wclk_i(clk_td_i), .wrst_i(rst_td_i), .push_i(push), .wdata_i(captured), .full_o(),
        .wawake_o(sent_awake),
        .rclk_i(clk_i), .rrst_i(rst_i), .pop_i(1'b1), .rdata_o(word), .empty_o(none),
        .rawake_o(come_awake)
    );
    // verilator lint_on PINCONNECTEMPTY
    video_writer writer (
        .clk_i(clk_i), .rst_i(rst_i), .enable_i(enable), .buffer_i(buffer),
        .came_i(!none), .word_i(word),
        .onchip_req_o(onchip_req_o), .onchip_take_i(onchip_take_i),
        .sdram_req_o(sdram_req_o), .sdram_take_i(sdram_take_i),
        .index_o(index_o), .wdata_o(wdata_o), .begin_o(picture_begin), .awake_o(writer_awake)
    );

    assign awake_o    = dma_awake || edges_rdata_q || come_awake || writer_awake;
    assign td_awake_o = enable || capture_awake || sent_awake;
endmodule

`default_nettype wire
