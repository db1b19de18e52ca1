// altfp_add_sub.v - the sum or the difference of two floating-point numbers, with a pipeline
//
// A denormal number is taken for 0, as a result also.  add_sub, with DIRECTION "VARIABLE", is 1
// for a sum.
//
// Source: Intel, "Floating-Point IP Cores User Guide" (683750).
//
// Not handled: denormal numbers.

`default_nettype none
// Texts of different lengths, and exponents as wide as they need to be.
// verilator lint_off WIDTH

module altfp_add_sub #(
    parameter width_exp = 8, WIDTH_EXP = width_exp,
    parameter width_man = 23, WIDTH_MAN = width_man,
    parameter pipeline = 11, PIPELINE = pipeline,
    parameter direction = "ADD", DIRECTION = direction,
    // Without meaning here.
    parameter rounding = "TO_NEAREST", ROUNDING = rounding,
    parameter exception_handling = "YES", EXCEPTION_HANDLING = exception_handling,
    parameter denormal_support = "NO", DENORMAL_SUPPORT = denormal_support,
    parameter reduced_functionality = "NO", REDUCED_FUNCTIONALITY = reduced_functionality,
    parameter optimize = "SPEED", OPTIMIZE = optimize,
    parameter speed_optimized = "STRATIX_ONLY", SPEED_OPTIMIZED = speed_optimized,
    parameter lpm_hint = "UNUSED", LPM_HINT = lpm_hint,
    parameter lpm_type = "altfp_add_sub", LPM_TYPE = lpm_type,
    parameter intended_device_family = "UNUSED", INTENDED_DEVICE_FAMILY = intended_device_family
) (
    input  wire                         clock, clk_en, aclr,
    input  wire [WIDTH_EXP+WIDTH_MAN:0] dataa, datab,
    input  wire                         add_sub,
    output wire [WIDTH_EXP+WIDTH_MAN:0] result,
    output wire                         overflow, underflow, zero, nan
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
    wire adds   = DIRECTION == "VARIABLE" ? add_sub : DIRECTION != "SUB";
    wire b_sign_now = b_sign ^ !adds;

    // The greater one, and the other one moved to its exponent; 0 has nothing to move.
    wire b_greater = !b_zero && (a_zero || {b_exponent, b_significand} > {a_exponent,
        a_significand});
    wire           sign  = b_greater ? b_sign_now : a_sign;
    wire [EXP-1:0] exponent = b_greater ? b_exponent : a_exponent;
    wire [EXP-1:0] far   = b_greater ? b_exponent - a_exponent : a_exponent - b_exponent;
    wire [MAN:0]   great = b_greater ? b_significand : a_significand;
    wire [MAN:0]   little = a_zero || b_zero ? 0 : b_greater ? a_significand : b_significand;
    localparam BITS = 2 * MAN + 6;
    wire [BITS-1:0] whole = {great, {MAN+5{1'b0}}} >> 1;     // a bit above, for a carry
    wire [BITS-1:0] moved = far > MAN + 3 ? little != 0 : ({little, {MAN+5{1'b0}}} >> 1) >> far;
    wire [BITS-1:0] sum   = a_sign == b_sign_now ? whole + moved : whole - moved;

    // Its top bit comes to the left.
    integer        n;
    reg [BITS-1:0] left;
    reg signed [EXP+2:0] top;
    always @* begin
        left = sum;
        top  = $signed({3'd0, exponent}) + 1;
        for (n = 0; n < BITS; n = n + 1)
            if (!left[BITS-1]) begin
                left = left << 1;
                top  = top - 1;
            end
    end
    wire no_number = a_nan || b_nan || (a_infinity && b_infinity && a_sign != b_sign_now);
    wire none      = sum == 0 || (a_zero && b_zero);
    wire infinite  = a_infinity || b_infinity;
    wire shown     = a_infinity ? a_sign : b_infinity ? b_sign_now
                     : none ? a_sign && b_sign_now && a_zero && b_zero : sign;

    wire [EXP+MAN:0] now;
    wire             nan_now, overflow_now, underflow_now, zero_now;
    de1sim_float #(.EXP(EXP), .MAN(MAN)) value (
        .sign_i(shown), .exponent_i(top), .significand_i({left[BITS-1:BITS-MAN-2],
            left[BITS-MAN-3:0] != 0}),
        .nan_i(no_number), .infinity_i(infinite), .zero_i(none), .result_o(now), .nan_o(nan_now),
        .overflow_o(overflow_now), .underflow_o(underflow_now), .zero_o(zero_now));
    de1sim_pipeline #(.WIDTH(EXP + MAN + 5), .STAGES(PIPELINE)) registers (
        .clock_i(clock), .clken_i(clk_en), .aclr_i(aclr), .sclr_i(1'b0),
        .d_i({now, nan_now, overflow_now, underflow_now, zero_now}),
        .q_o({result, nan, overflow, underflow, zero}));
// verilator lint_on WIDTH
endmodule

`default_nettype wire
