// de10_standard.v - the bands on a DE10-Standard, which has the DE1-SoC's parts on other pins

module de10_standard (
    input        CLOCK_50,
    input  [3:0] KEY,
    input  [9:0] SW,
    output [9:0] LEDR,
    output [6:0] HEX0,
    output       VGA_CLK,
    output       VGA_HS,
    output       VGA_VS,
    output       VGA_BLANK_N,
    output       VGA_SYNC_N,
    output [7:0] VGA_R,
    output [7:0] VGA_G,
    output [7:0] VGA_B
);
    reg clock = 0;
    always @(posedge CLOCK_50) clock <= ~clock;

    wire [7:0] count;
    wire [3:0] red, green, blue;
    bands picture (.clock(clock), .key_n(KEY[0]), .negative(SW[0]), .hs(VGA_HS), .vs(VGA_VS),
                   .visible(VGA_BLANK_N), .red(red), .green(green), .blue(blue), .count(count));
    seven_segment counted (.digit(count[3:0]), .segments_n(HEX0));

    assign LEDR = SW;
    assign VGA_CLK = ~clock;
    assign VGA_SYNC_N = 0;
    assign VGA_R = {red, red};
    assign VGA_G = {green, green};
    assign VGA_B = {blue, blue};
endmodule
