// de10_lite.v - the bands on a DE10-Lite: 4 bits a colour, and the way it is tilted on the LEDs
//
// HEX0 counts KEY0, its point is lit while KEY0 is held.  HEX5 and HEX4 have the accelerometer's X,
// bits 9 to 2, read by SPI; the LEDs have SW.

module de10_lite (
    input        MAX10_CLK1_50,
    input  [1:0] KEY,
    input  [9:0] SW,
    output [9:0] LEDR,
    output [7:0] HEX0,
    output [7:0] HEX4,
    output [7:0] HEX5,
    output       VGA_HS,
    output       VGA_VS,
    output [3:0] VGA_R,
    output [3:0] VGA_G,
    output [3:0] VGA_B,
    output       GSENSOR_CS_N,
    output       GSENSOR_SCLK,
    inout        GSENSOR_SDI,
    inout        GSENSOR_SDO
);
    reg clock = 0;
    always @(posedge MAX10_CLK1_50) clock <= ~clock;

    wire [7:0] count, tilt;
    wire [6:0] low, high, digit;
    bands picture (.clock(clock), .key_n(KEY[0]), .negative(SW[0]), .hs(VGA_HS), .vs(VGA_VS),
                   .visible(), .red(VGA_R), .green(VGA_G), .blue(VGA_B), .count(count));
    tilt_sensor sensor (.clock(clock), .cs_n(GSENSOR_CS_N), .sclk(GSENSOR_SCLK),
                        .sdi(GSENSOR_SDI), .sdo(GSENSOR_SDO), .x(tilt));
    seven_segment counted (.digit(count[3:0]), .segments_n(digit));
    seven_segment lower (.digit(tilt[3:0]), .segments_n(low));
    seven_segment upper (.digit(tilt[7:4]), .segments_n(high));

    assign LEDR = SW;
    assign HEX0 = {KEY[0], digit};
    assign HEX4 = {1'b1, low};
    assign HEX5 = {1'b1, high};
endmodule
