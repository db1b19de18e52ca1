// ycbcr_to_rgb.v - a pixel of ITU-R BT.601 as RGB565
//
//   R = 1.164 (Y - 16)                     + 1.596 (Cr - 128)
//   G = 1.164 (Y - 16) - 0.391 (Cb - 128)  - 0.813 (Cr - 128)
//   B = 1.164 (Y - 16) + 2.018 (Cb - 128)
//
// in 256ths, rounded, and clipped to 0 to 255; the lowest bits are then left out.  A factor is a
// sum of shifts and not a multiplier, because the open tools have no cell for the device's
// multipliers.

`default_nettype none

module ycbcr_to_rgb (
    input  wire [7:0]  y_i,
    input  wire [7:0]  cb_i,
    input  wire [7:0]  cr_i,
    output wire [15:0] rgb_o     // R 15:11, G 10:5, B 4:0
);
    wire signed [18:0] y  = $signed({11'd0, y_i}) - 19'sd16;
    wire signed [18:0] cb = $signed({11'd0, cb_i}) - 19'sd128;
    wire signed [18:0] cr = $signed({11'd0, cr_i}) - 19'sd128;

    // 298 Y, and half a step to round.
    wire signed [18:0] light = (y <<< 8) + (y <<< 5) + (y <<< 3) + (y <<< 1) + 19'sd128;
    // 409 Cr; 100 Cb + 208 Cr; 516 Cb.
    wire signed [18:0] red   = light + (cr <<< 8) + (cr <<< 7) + (cr <<< 4) + (cr <<< 3) + cr;
    wire signed [18:0] green = light - (cb <<< 6) - (cb <<< 5) - (cb <<< 2)
                                     - (cr <<< 7) - (cr <<< 6) - (cr <<< 4);
    wire signed [18:0] blue  = light + (cb <<< 9) + (cb <<< 2);

    // Bits below the upper six are left out.
    // verilator lint_off UNUSED
    function [5:0] clipped;
        input [18:0] value;
        clipped = value[18] ? 6'd0 : value[17:16] != 2'd0 ? 6'd63 : value[15:10];
    endfunction

    wire [5:0] r = clipped(red), b = clipped(blue);
    // verilator lint_on UNUSED

    assign rgb_o = {r[5:1], clipped(green), b[5:1]};
endmodule

`default_nettype wire
