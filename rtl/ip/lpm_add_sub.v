// lpm_add_sub.v - a sum or a difference, with carries and a pipeline
//
// cout of a difference is 1 where nothing was borrowed.  overflow is that of signed numbers, or
// with UNSIGNED that the result does not fit.
//
// Not handled: cin of a difference, which counts as open.

`default_nettype none
// Texts of different lengths, and parameters with numbers.
// verilator lint_off WIDTH

module lpm_add_sub #(
    parameter lpm_width = 1, LPM_WIDTH = lpm_width,
    parameter lpm_representation = "SIGNED", LPM_REPRESENTATION = lpm_representation,
    parameter lpm_direction = "UNUSED", LPM_DIRECTION = lpm_direction,
    parameter lpm_pipeline = 0, LPM_PIPELINE = lpm_pipeline,
    // Without meaning here.
    parameter one_input_is_constant = "NO", ONE_INPUT_IS_CONSTANT = one_input_is_constant,
    parameter maximize_speed = 5, MAXIMIZE_SPEED = maximize_speed,
    parameter optimize_for_speed = 5, OPTIMIZE_FOR_SPEED = optimize_for_speed,
    parameter lpm_hint = "UNUSED", LPM_HINT = lpm_hint,
    parameter lpm_type = "lpm_add_sub", LPM_TYPE = lpm_type,
    parameter intended_device_family = "UNUSED", INTENDED_DEVICE_FAMILY = intended_device_family
) (
    input  wire                 clock, clken, aclr,
    input  wire                 add_sub,            // 1 adds
    input  wire                 cin,
    input  wire [LPM_WIDTH-1:0] dataa, datab,
    output wire [LPM_WIDTH-1:0] result,
    output wire                 cout, overflow
);
    localparam SIGN = LPM_WIDTH - 1;

    wire add = LPM_DIRECTION == "ADD" || LPM_DIRECTION != "SUB" && add_sub;
    wire [LPM_WIDTH-1:0] b   = add ? datab : ~datab;
    wire [LPM_WIDTH:0]   sum = {1'b0, dataa} + {1'b0, b} + (add ? cin : 1'b1);
    wire carry = sum[LPM_WIDTH];
    wire over  = LPM_REPRESENTATION == "UNSIGNED" ? carry != !add
               : dataa[SIGN] == b[SIGN] && sum[SIGN] != b[SIGN];

    de1sim_pipeline #(.WIDTH(LPM_WIDTH + 2), .STAGES(LPM_PIPELINE)) pipeline (
        .clock_i(clock), .clken_i(clken), .aclr_i(aclr), .sclr_i(1'b0),
        .d_i({over, sum}), .q_o({overflow, cout, result}));
// verilator lint_on WIDTH
endmodule

`default_nettype wire
