// altfp_compare.v - compares two floating-point numbers, with a pipeline
//
// With one that is not a number unordered is 1, and all others are 0 but aneb.  A denormal number
// is taken for 0.
//
// Source: Intel, "Floating-Point IP Cores User Guide" (683750).
//
// Not handled: denormal numbers; what aneb is with one that is not a number has not been compared
// with the device.

`default_nettype none
// Texts of different lengths, and exponents as wide as they need to be.
// verilator lint_off WIDTH

module altfp_compare #(
    parameter width_exp = 8, WIDTH_EXP = width_exp,
    parameter width_man = 23, WIDTH_MAN = width_man,
    parameter pipeline = 1, PIPELINE = pipeline,
    // Without meaning here.
    parameter rounding = "TO_NEAREST", ROUNDING = rounding,
    parameter exception_handling = "YES", EXCEPTION_HANDLING = exception_handling,
    parameter denormal_support = "NO", DENORMAL_SUPPORT = denormal_support,
    parameter reduced_functionality = "NO", REDUCED_FUNCTIONALITY = reduced_functionality,
    parameter lpm_hint = "UNUSED", LPM_HINT = lpm_hint,
    parameter lpm_type = "altfp_compare", LPM_TYPE = lpm_type,
    parameter intended_device_family = "UNUSED", INTENDED_DEVICE_FAMILY = intended_device_family
) (
    input  wire                         clock, clk_en, aclr,
    input  wire [WIDTH_EXP+WIDTH_MAN:0] dataa, datab,
    output wire                         aeb, aneb, agb, ageb, alb, aleb, unordered
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
    wire [EXP+MAN:0] a_size = a_zero ? 0 : {a_exponent, a_significand};
    wire [EXP+MAN:0] b_size = b_zero ? 0 : {b_exponent, b_significand};
    wire none    = a_nan || b_nan;
    wire equal   = !none && a_size == b_size && (a_sign == b_sign || a_size == 0);
    wire greater = !none && !equal && (a_sign != b_sign ? b_sign : (a_size > b_size) != a_sign);
    wire less    = !none && !equal && !greater;
    de1sim_pipeline #(.WIDTH(7), .STAGES(PIPELINE)) registers (
        .clock_i(clock), .clken_i(clk_en), .aclr_i(aclr), .sclr_i(1'b0),
        .d_i({equal, !equal, greater, greater || equal, less, less || equal, none}),
        .q_o({aeb, aneb, agb, ageb, alb, aleb, unordered}));
// verilator lint_on WIDTH
endmodule

`default_nettype wire
