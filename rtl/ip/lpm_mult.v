// lpm_mult.v - a product and a sum, with a pipeline
//
// result has the upper bits of dataa * datab + sum where it is narrower than both together.

`default_nettype none
// Texts of different lengths, and parameters with numbers.
// verilator lint_off WIDTH

module lpm_mult #(
    parameter lpm_widtha = 1, LPM_WIDTHA = lpm_widtha,
    parameter lpm_widthb = 1, LPM_WIDTHB = lpm_widthb,
    parameter lpm_widths = 1, LPM_WIDTHS = lpm_widths,
    parameter lpm_widthp = 1, LPM_WIDTHP = lpm_widthp,
    parameter lpm_representation = "UNSIGNED", LPM_REPRESENTATION = lpm_representation,
    parameter lpm_pipeline = 0, LPM_PIPELINE = lpm_pipeline,
    // Without meaning here.
    parameter input_a_is_constant = "NO", INPUT_A_IS_CONSTANT = input_a_is_constant,
    parameter input_b_is_constant = "NO", INPUT_B_IS_CONSTANT = input_b_is_constant,
    parameter dedicated_multiplier_circuitry = "AUTO",
    parameter DEDICATED_MULTIPLIER_CIRCUITRY = dedicated_multiplier_circuitry,
    parameter maximize_speed = 5, MAXIMIZE_SPEED = maximize_speed,
    parameter lpm_hint = "UNUSED", LPM_HINT = lpm_hint,
    parameter lpm_type = "lpm_mult", LPM_TYPE = lpm_type,
    parameter intended_device_family = "UNUSED", INTENDED_DEVICE_FAMILY = intended_device_family
) (
    input  wire                  clock, clken, aclr, sclr,
    input  wire [LPM_WIDTHA-1:0] dataa,
    input  wire [LPM_WIDTHB-1:0] datab,
    input  wire [LPM_WIDTHS-1:0] sum,
    output wire [LPM_WIDTHP-1:0] result
);
    localparam SIGNED = LPM_REPRESENTATION == "SIGNED";
    localparam AB     = LPM_WIDTHA + LPM_WIDTHB;
    localparam FULL   = LPM_WIDTHS > AB ? LPM_WIDTHS : AB;
    localparam WIDTH  = LPM_WIDTHP > FULL ? LPM_WIDTHP : FULL;

    wire signed [WIDTH-1:0] a = {{WIDTH{SIGNED && dataa[LPM_WIDTHA-1]}}, dataa};
    wire signed [WIDTH-1:0] b = {{WIDTH{SIGNED && datab[LPM_WIDTHB-1]}}, datab};
    wire signed [WIDTH-1:0] s = {{WIDTH{SIGNED && sum[LPM_WIDTHS-1]}}, sum};
    wire signed [WIDTH-1:0] p = a * b + s;

    de1sim_pipeline #(.WIDTH(LPM_WIDTHP), .STAGES(LPM_PIPELINE)) pipeline (
        .clock_i(clock), .clken_i(clken), .aclr_i(aclr), .sclr_i(sclr),
        .d_i(LPM_WIDTHP < FULL ? p[FULL-1 -: (LPM_WIDTHP < FULL ? LPM_WIDTHP : FULL)] : p),
        .q_o(result));
// verilator lint_on WIDTH
endmodule

`default_nettype wire
