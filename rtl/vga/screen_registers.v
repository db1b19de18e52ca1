// screen_registers.v - the registers of the pixel and the character buffer controller
//
// The two controllers feed one mixer of pixels and characters.  So while EN of either is 0 there is
// no picture, and no swap of either.

`default_nettype none

module screen_registers (
    input  wire        clk_i,
    input  wire        rst_i,

    input  wire        we_i,            // PIXEL
    input  wire [3:0]  wstrb_i,
    input  wire [11:0] waddr_i,
    input  wire [31:0] wdata_i,
    input  wire        re_i,
    input  wire        resampler_re_i,  // RESAMPLER
    input  wire        text_we_i,       // TEXT
    input  wire        text_re_i,
    input  wire [11:0] raddr_i,
    output wire [31:0] rdata_o,

    input  wire        frame_end_i,     // the last line has been fetched
    output wire [31:0] front_o,         // address of the picture on screen
    output wire [12:0] text_front_o,    // of the characters on screen, in their memory
    output wire        enable_o,
    output reg         clear_o,         // the characters, for one clock
    input  wire        clearing_i,

    output wire        awake_o
);
    `include "regmap.vh"

    wire [31:0] pixel_rdata, text_rdata;
    // The characters' memory is the only one that their controller reaches.
    // verilator lint_off UNUSED
    wire [31:0] text_front;
    // verilator lint_on UNUSED
    wire        pixel_awake, text_awake, pixel_enable, text_enable;
    wire        swap = frame_end_i && enable_o;
    reg         clearing_rdata_q;

    pixel_registers #(
        .BUFFER(PIXEL_BUFFER_RESET), .RESOLUTION(PIXEL_RESOLUTION_RESET),
        .STATUS(PIXEL_STATUS_RESET)
    ) pixel (
        .clk_i(clk_i), .rst_i(rst_i),
        .we_i(we_i), .wstrb_i(wstrb_i), .waddr_i(waddr_i), .wdata_i(wdata_i),
        .re_i(re_i), .resampler_re_i(resampler_re_i), .raddr_i(raddr_i), .rdata_o(pixel_rdata),
        .swap_i(swap), .front_o(front_o), .enable_o(pixel_enable), .awake_o(pixel_awake)
    );
    pixel_registers #(
        .BUFFER(TEXT_BUFFER_RESET), .RESOLUTION(TEXT_RESOLUTION_RESET), .STATUS(TEXT_STATUS_RESET)
    ) text (
        .clk_i(clk_i), .rst_i(rst_i),
        .we_i(text_we_i), .wstrb_i(wstrb_i), .waddr_i(waddr_i), .wdata_i(wdata_i),
        .re_i(text_re_i), .resampler_re_i(1'b0), .raddr_i(raddr_i), .rdata_o(text_rdata),
        .swap_i(swap), .front_o(text_front), .enable_o(text_enable), .awake_o(text_awake)
    );

    assign enable_o     = pixel_enable && text_enable;
    assign text_front_o = text_front[12:0];

    assign rdata_o = pixel_rdata | text_rdata
                     | {31'd0, clearing_rdata_q} << TEXT_BUFFER_CLEAR_LSB;
    assign awake_o = pixel_awake || text_awake || clear_o || clearing_rdata_q;

    always @(posedge clk_i) begin
        clearing_rdata_q <= text_re_i && raddr_i[3:0] == TEXT_BUFFER[3:0]
                            && (clear_o || clearing_i);
        clear_o <= text_we_i && waddr_i[3:0] == TEXT_BUFFER[3:0] && wstrb_i[2]
                   && wdata_i[TEXT_BUFFER_CLEAR_LSB] && !rst_i;
    end
endmodule

`default_nettype wire
