// de1sim_float.v - a value as a floating-point number: rounded, or infinity, zero, not a number
//
// The value is significand_i * 2^(exponent_i - bias - (MAN + 2)).  The significand's top bit is 1;
// its lowest bit stands for all that is lost below.  It is rounded to the nearest, of two as near
// to the even one.  What is too small for a normal number is 0.
//
// Source: IEEE 754; Intel, "Floating-Point IP Cores User Guide" (683750), which has no denormal
// numbers.

`default_nettype none
// Exponents are as wide as they need to be.
// verilator lint_off WIDTH

module de1sim_float #(
    parameter EXP = 8,
    parameter MAN = 23
) (
    input  wire                  sign_i,
    input  wire signed [EXP+2:0] exponent_i,   // with the bias
    input  wire [MAN+2:0]        significand_i,
    input  wire                  nan_i, infinity_i, zero_i,   // it is none of these but this
    output wire [EXP+MAN:0]      result_o,
    output wire                  nan_o, overflow_o, underflow_o, zero_o
);
    localparam signed [EXP+2:0] TOP = (1 << EXP) - 1;

    wire             up = significand_i[1] && (significand_i[0] || significand_i[2]);
    wire [MAN+1:0]   rounded = {1'b0, significand_i[MAN+2:2]} + up;
    wire signed [EXP+2:0] exponent = exponent_i + $signed({1'b0, rounded[MAN+1]});

    wire finite = !nan_i && !infinity_i && !zero_i;
    wire huge   = finite && exponent >= TOP;
    wire tiny   = finite && exponent < 1;
    assign nan_o       = nan_i;
    assign overflow_o  = !nan_i && (infinity_i || huge);
    assign underflow_o = tiny;
    assign zero_o      = !nan_i && (zero_i || tiny);
    assign result_o    = nan_o      ? {1'b0, {EXP+1{1'b1}}, {MAN-1{1'b0}}}
                         : overflow_o ? {sign_i, {EXP{1'b1}}, {MAN{1'b0}}}
                         : zero_o   ? {sign_i, {EXP+MAN{1'b0}}}
                         : {sign_i, exponent[EXP-1:0], rounded[MAN-1:0]};
// verilator lint_on WIDTH
endmodule

`default_nettype wire
