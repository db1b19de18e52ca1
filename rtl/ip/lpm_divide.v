// lpm_divide.v - quotient and remainder, with a pipeline
//
// The quotient is cut off towards 0.  The remainder has the sign of numer, or with
// lpm_remainderpositive "TRUE", its default, it is never negative, and the quotient is one further
// from 0 where that takes it.  Of a division by 0 nothing is promised; here both are 0.

`default_nettype none
// Texts of different lengths, and parameters with numbers.
// verilator lint_off WIDTH

module lpm_divide #(
    parameter lpm_widthn = 1, LPM_WIDTHN = lpm_widthn,
    parameter lpm_widthd = 1, LPM_WIDTHD = lpm_widthd,
    parameter lpm_nrepresentation = "UNSIGNED", LPM_NREPRESENTATION = lpm_nrepresentation,
    parameter lpm_drepresentation = "UNSIGNED", LPM_DREPRESENTATION = lpm_drepresentation,
    parameter lpm_remainderpositive = "TRUE", LPM_REMAINDERPOSITIVE = lpm_remainderpositive,
    parameter lpm_pipeline = 0, LPM_PIPELINE = lpm_pipeline,
    // Without meaning here.
    parameter maximize_speed = 5, MAXIMIZE_SPEED = maximize_speed,
    parameter lpm_hint = "UNUSED", LPM_HINT = lpm_hint,
    parameter lpm_type = "lpm_divide", LPM_TYPE = lpm_type,
    parameter intended_device_family = "UNUSED", INTENDED_DEVICE_FAMILY = intended_device_family
) (
    input  wire                  clock, clken, aclr,
    input  wire [LPM_WIDTHN-1:0] numer,
    input  wire [LPM_WIDTHD-1:0] denom,
    output wire [LPM_WIDTHN-1:0] quotient,
    output wire [LPM_WIDTHD-1:0] remain
);
    // Magnitudes are divided, and signs put to them.
    wire n_neg = LPM_NREPRESENTATION == "SIGNED" && numer[LPM_WIDTHN-1];
    wire d_neg = LPM_DREPRESENTATION == "SIGNED" && denom[LPM_WIDTHD-1];
    wire [LPM_WIDTHN-1:0] n = n_neg ? -numer : numer;
    wire [LPM_WIDTHD-1:0] d = d_neg ? -denom : denom;
    wire [LPM_WIDTHN-1:0] q = d == 0 ? 0 : n / d;
    wire [LPM_WIDTHD-1:0] r = d == 0 ? 0 : n % d;

    wire further = LPM_REMAINDERPOSITIVE == "TRUE" && n_neg && r != 0;
    wire [LPM_WIDTHN-1:0] q_far = q + further;
    wire [LPM_WIDTHN-1:0] q_all = n_neg != d_neg ? -q_far : q_far;
    wire [LPM_WIDTHD-1:0] r_all = further ? d - r : n_neg ? -r : r;

    de1sim_pipeline #(.WIDTH(LPM_WIDTHN + LPM_WIDTHD), .STAGES(LPM_PIPELINE)) pipeline (
        .clock_i(clock), .clken_i(clken), .aclr_i(aclr), .sclr_i(1'b0), .d_i({q_all, r_all}),
        .q_o({quotient, remain}));
// verilator lint_on WIDTH
endmodule

`default_nettype wire
