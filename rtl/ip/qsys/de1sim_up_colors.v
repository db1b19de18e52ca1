// de1sim_up_colors.v - the University Program's colour space converter: Cr Cb Y, RGB and Y alone, 8
// bits each, by ITU-R BT.601
//
//   R = 1.164 (Y - 16) + 1.596 (Cr - 128)
//   G = 1.164 (Y - 16) - 0.813 (Cr - 128) - 0.392 (Cb - 128)
//   B = 1.164 (Y - 16) + 2.017 (Cb - 128)
//
//   Y  = 0.257 R + 0.504 G + 0.098 B + 16
//   Cr = 0.439 R - 0.368 G - 0.071 B + 128
//   Cb = 0.439 B - 0.291 G - 0.148 R + 128
//
// Factors are in 32,768ths; a product is rounded down, a sum is clipped to 0 to 255.

`default_nettype none
// The kinds differ in their widths.
// verilator lint_off WIDTH

module de1sim_up_colors #(
    parameter KIND = 1,  // 0: RGB to YCrCb, 1: the reverse, 2: RGB to Y, 3: the reverse
    parameter IN   = KIND == 3 ? 8 : 24,
    parameter OUT  = KIND == 2 ? 8 : 24
) (
    // verilator lint_off UNUSED
    input  wire           clk,
    input  wire           reset,
    input  wire [IN-1:0]  stream_in_data,
    input  wire           stream_in_startofpacket,
    input  wire           stream_in_endofpacket,
    input  wire           stream_in_valid,
    output wire           stream_in_ready,
    output wire [OUT-1:0] stream_out_data,
    output wire           stream_out_startofpacket,
    output wire           stream_out_endofpacket,
    output wire           stream_out_valid,
    input  wire           stream_out_ready
    // verilator lint_on UNUSED
);
    // The whole part of value * factor / 32768.
    // verilator lint_off UNUSED
    function signed [31:0] times(input signed [31:0] value, input signed [31:0] factor);
        times = (value * factor) >>> 15;
    endfunction
    function [7:0] clipped(input signed [31:0] value);
        clipped = value < 0 ? 8'd0 : value > 255 ? 8'd255 : value[7:0];
    endfunction
    // verilator lint_on UNUSED

    wire [23:0]        in = KIND == 3 ? {3{stream_in_data[7:0]}} : stream_in_data;
    wire signed [31:0] a  = {24'd0, in[23:16]};    // Cr, R
    wire signed [31:0] b  = {24'd0, in[15:8]};     // Cb, G
    wire signed [31:0] c  = {24'd0, in[7:0]};      // Y, B

    wire [23:0] rgb = {clipped(times(c - 16, 38141) + times(a - 128, 52297)),
                       clipped(times(c - 16, 38141) - times(a - 128, 26640)
                               - times(b - 128, 12845)),
                       clipped(times(c - 16, 38141) + times(b - 128, 66093))};
    wire [23:0] ycrcb = {clipped(128 + times(a, 14385) - times(b, 12059) - times(c, 2327)),
                         clipped(128 + times(c, 14385) - times(b, 9535) - times(a, 4850)),
                         clipped(16 + times(a, 8421) + times(b, 16515) + times(c, 3213))};

    assign stream_out_data = KIND == 0 ? ycrcb : KIND == 1 ? rgb : KIND == 2 ? ycrcb[7:0] : in;
    assign stream_out_startofpacket = stream_in_startofpacket;
    assign stream_out_endofpacket   = stream_in_endofpacket;
    assign stream_out_valid         = stream_in_valid;
    assign stream_in_ready          = stream_out_ready;
// verilator lint_on WIDTH
endmodule

`default_nettype wire
