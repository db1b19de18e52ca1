// altfp_mult.v - the product of two floating-point numbers, with a pipeline
//
// A denormal number is taken for 0, as a result also.
//
// Source: Intel, "Floating-Point IP Cores User Guide" (683750).
//
// Not handled: denormal numbers; indefinite.

`default_nettype none
// Texts of different lengths, and exponents as wide as they need to be.
// verilator lint_off WIDTH

module altfp_mult #(
    parameter width_exp = 8, WIDTH_EXP = width_exp,
    parameter width_man = 23, WIDTH_MAN = width_man,
    parameter pipeline = 5, PIPELINE = pipeline,
    // Without meaning here.
    parameter rounding = "TO_NEAREST", ROUNDING = rounding,
    parameter exception_handling = "YES", EXCEPTION_HANDLING = exception_handling,
    parameter denormal_support = "NO", DENORMAL_SUPPORT = denormal_support,
    parameter reduced_functionality = "NO", REDUCED_FUNCTIONALITY = reduced_functionality,
    parameter dedicated_multiplier_circuitry = "AUTO",
        DEDICATED_MULTIPLIER_CIRCUITRY = dedicated_multiplier_circuitry,
    parameter lpm_hint = "UNUSED", LPM_HINT = lpm_hint,
    parameter lpm_type = "altfp_mult", LPM_TYPE = lpm_type,
    parameter intended_device_family = "UNUSED", INTENDED_DEVICE_FAMILY = intended_device_family
) (
    input  wire                         clock, clk_en, aclr,
    input  wire [WIDTH_EXP+WIDTH_MAN:0] dataa, datab,
    output wire [WIDTH_EXP+WIDTH_MAN:0] result,
    output wire                         overflow, underflow, zero, nan, denormal, indefinite
);
    localparam EXP = WIDTH_EXP, MAN = WIDTH_MAN;
    wire a_sign, a_nan, a_infinity, a_zero;
    wire [EXP-1:0] a_exponent;
    wire [MAN:0]   a_significand;
    de1sim_float_operand #(.EXP(EXP), .MAN(MAN)) a (
        .number_i(dataa), .sign_o(a_sign), .nan_o(a_nan), .infinity_o(a_infinity),
        .zero_o(a_zero), .exponent_o(a_exponent), .significand_o(a_significand));
    wire b_sign, b_nan, b_infinity, b_zero;
    wire [EXP-1:0] b_exponent;
    wire [MAN:0]   b_significand;
    de1sim_float_operand #(.EXP(EXP), .MAN(MAN)) b (
        .number_i(datab), .sign_o(b_sign), .nan_o(b_nan), .infinity_o(b_infinity),
        .zero_o(b_zero), .exponent_o(b_exponent), .significand_o(b_significand));
    wire [2*MAN+1:0] product = a_significand * b_significand;
    wire             upper   = product[2*MAN+1];
    wire [2*MAN+1:0] aligned = upper ? product : product << 1;
    wire signed [EXP+2:0] exponent =
        $signed({3'd0, a_exponent}) + $signed({3'd0, b_exponent}) - (1 << (EXP - 1)) + 1 + upper;
    wire             no_number = a_nan || b_nan || (a_infinity && b_zero) || (a_zero && b_infinity);
    assign {denormal, indefinite} = 2'b00;

    wire [EXP+MAN:0] now;
    wire             nan_now, overflow_now, underflow_now, zero_now;
    de1sim_float #(.EXP(EXP), .MAN(MAN)) value (
        .sign_i(a_sign ^ b_sign), .exponent_i(exponent), .significand_i({aligned[2*MAN+1:MAN],
            aligned[MAN-1:0] != 0}),
        .nan_i(no_number), .infinity_i(a_infinity || b_infinity), .zero_i(a_zero || b_zero),
            .result_o(now), .nan_o(nan_now),
        .overflow_o(overflow_now), .underflow_o(underflow_now), .zero_o(zero_now));
    de1sim_pipeline #(.WIDTH(EXP + MAN + 5), .STAGES(PIPELINE)) registers (
        .clock_i(clock), .clken_i(clk_en), .aclr_i(aclr), .sclr_i(1'b0),
        .d_i({now, nan_now, overflow_now, underflow_now, zero_now}),
        .q_o({result, nan, overflow, underflow, zero}));
// verilator lint_on WIDTH
endmodule

`default_nettype wire
