// altfp_sqrt.v - the square root of a floating-point number, with a pipeline
//
// Of a number below 0 it is not a number; of -0 it is -0.  A denormal number is taken for 0.
//
// Source: Intel, "Floating-Point IP Cores User Guide" (683750).
//
// Not handled: denormal numbers.

`default_nettype none
// Texts of different lengths, and exponents as wide as they need to be.
// verilator lint_off WIDTH

module altfp_sqrt #(
    parameter width_exp = 8, WIDTH_EXP = width_exp,
    parameter width_man = 23, WIDTH_MAN = width_man,
    parameter pipeline = 28, PIPELINE = pipeline,
    // Without meaning here.
    parameter rounding = "TO_NEAREST", ROUNDING = rounding,
    parameter exception_handling = "YES", EXCEPTION_HANDLING = exception_handling,
    parameter denormal_support = "NO", DENORMAL_SUPPORT = denormal_support,
    parameter reduced_functionality = "NO", REDUCED_FUNCTIONALITY = reduced_functionality,
    parameter lpm_hint = "UNUSED", LPM_HINT = lpm_hint,
    parameter lpm_type = "altfp_sqrt", LPM_TYPE = lpm_type,
    parameter intended_device_family = "UNUSED", INTENDED_DEVICE_FAMILY = intended_device_family
) (
    input  wire                         clock, clk_en, aclr,
    input  wire [WIDTH_EXP+WIDTH_MAN:0] data,
    output wire [WIDTH_EXP+WIDTH_MAN:0] result,
    output wire                         overflow, zero, nan
);
    localparam EXP = WIDTH_EXP, MAN = WIDTH_MAN;
    wire a_sign, a_nan, a_infinity, a_zero;
    wire [EXP-1:0] a_exponent;
    wire [MAN:0]   a_significand;
    de1sim_float_operand #(.EXP(EXP), .MAN(MAN)) a (
        .number_i(data), .sign_o(a_sign), .nan_o(a_nan), .infinity_o(a_infinity),
        .zero_o(a_zero), .exponent_o(a_exponent), .significand_o(a_significand));
    // The significand by an even power of 2, so that its root has MAN + 3 bits.
    localparam ROOT = MAN + 3;
    localparam [EXP-1:0] BIAS = (1 << (EXP - 1)) - 1;
    wire odd = a_exponent[0] != BIAS[0];
    wire [2*ROOT-1:0] radical = {1'b0, a_significand, {MAN+4{1'b0}}} << odd;
    wire [ROOT-1:0]   root;
    wire [ROOT:0]     rest;
    altsqrt #(.WIDTH(2 * ROOT), .Q_PORT_WIDTH(ROOT), .R_PORT_WIDTH(ROOT + 1)) digits (
        .clk(1'b0), .ena(1'b1), .aclr(1'b0), .radical(radical), .q(root), .remainder(rest));
    wire signed [EXP+2:0] exponent =
        ($signed({3'd0, a_exponent}) - $signed({3'd0, BIAS})
         - $signed({1'b0, odd})) / 2 + $signed({3'd0, BIAS});
    wire no_number = a_nan || (a_sign && !a_zero);
    wire underflow;   // never

    wire [EXP+MAN:0] now;
    wire             nan_now, overflow_now, underflow_now, zero_now;
    de1sim_float #(.EXP(EXP), .MAN(MAN)) value (
        .sign_i(a_sign), .exponent_i(exponent), .significand_i({root[ROOT-1:1], root[0]
            || rest != 0}),
        .nan_i(no_number), .infinity_i(a_infinity), .zero_i(a_zero), .result_o(now),
            .nan_o(nan_now),
        .overflow_o(overflow_now), .underflow_o(underflow_now), .zero_o(zero_now));
    de1sim_pipeline #(.WIDTH(EXP + MAN + 5), .STAGES(PIPELINE)) registers (
        .clock_i(clock), .clken_i(clk_en), .aclr_i(aclr), .sclr_i(1'b0),
        .d_i({now, nan_now, overflow_now, underflow_now, zero_now}),
        .q_o({result, nan, overflow, underflow, zero}));
// verilator lint_on WIDTH
endmodule

`default_nettype wire
