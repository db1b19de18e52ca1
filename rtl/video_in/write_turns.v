// write_turns.v - video-in's writes among the processor's accesses to the FPGA's memories
//
// On-chip memory: the processor first.  It leaves four clocks free in a burst of sixteen writes.
// SDRAM: video-in first, but a request that sdram.v has seen stays until it is taken, as sdram.v
// requires.

`default_nettype none

module write_turns (
    input  wire        clk_i,
    input  wire        rst_i,

    input  wire        onchip_busy_i,      // the processor writes to it now, or to the characters
    input  wire [15:0] onchip_windex_i,
    input  wire [31:0] onchip_wdata_i,
    input  wire [3:0]  onchip_we_i,

    input  wire        req_i,              // the processor's, for the SDRAM
    input  wire        we_i,
    input  wire [23:0] index_i,
    input  wire [31:0] wdata_i,
    input  wire [3:0]  wstrb_i,
    output wire        take_o,

    input  wire        video_onchip_i,     // video-in's, whole words
    output wire        video_onchip_take_o,
    input  wire        video_sdram_i,
    output wire        video_sdram_take_o,
    input  wire [23:0] video_index_i,
    input  wire [31:0] video_wdata_i,

    output wire [3:0]  onchip_we_o,
    output wire [15:0] onchip_windex_o,
    output wire [31:0] onchip_wdata_o,

    output wire        sdram_req_o,
    output wire        sdram_we_o,
    output wire [23:0] sdram_index_o,
    output wire [31:0] sdram_wdata_o,
    output wire [3:0]  sdram_wstrb_o,
    input  wire        sdram_take_i,

    output wire        awake_o             // or video-in has a word
);
    // ---- On-chip memory ---------------------------------------------------
    wire onchip = video_onchip_i && !onchip_busy_i;

    assign video_onchip_take_o = !onchip_busy_i;
    assign onchip_we_o     = onchip_we_i | {4{onchip}};
    assign onchip_windex_o = onchip ? video_index_i[15:0] : onchip_windex_i;
    assign onchip_wdata_o  = onchip ? video_wdata_i : onchip_wdata_i;

    // ---- SDRAM ------------------------------------------------------------
    reg  shown_q;                          // the processor's request is before sdram.v, not taken
    wire video = video_sdram_i && !shown_q;

    assign video_sdram_take_o = sdram_take_i && video;
    assign take_o        = sdram_take_i && !video;
    assign sdram_req_o   = video || req_i;
    assign sdram_we_o    = video || we_i;
    assign sdram_index_o = video ? video_index_i : index_i;
    assign sdram_wdata_o = video ? video_wdata_i : wdata_i;
    assign sdram_wstrb_o = video ? 4'b1111 : wstrb_i;

    assign awake_o = shown_q || video_onchip_i || video_sdram_i;

    always @(posedge clk_i) shown_q <= req_i && !video && !sdram_take_i && !rst_i;
endmodule

`default_nettype wire
