// lpm_compare.v - two numbers compared, with a pipeline

`default_nettype none
// Texts of different lengths, and parameters with numbers.
// verilator lint_off WIDTH

module lpm_compare #(
    parameter lpm_width = 1, LPM_WIDTH = lpm_width,
    parameter lpm_representation = "UNSIGNED", LPM_REPRESENTATION = lpm_representation,
    parameter lpm_pipeline = 0, LPM_PIPELINE = lpm_pipeline,
    // Without meaning here.
    parameter one_input_is_constant = "NO", ONE_INPUT_IS_CONSTANT = one_input_is_constant,
    parameter chain_size = 8, CHAIN_SIZE = chain_size,
    parameter lpm_hint = "UNUSED", LPM_HINT = lpm_hint,
    parameter lpm_type = "lpm_compare", LPM_TYPE = lpm_type,
    parameter intended_device_family = "UNUSED", INTENDED_DEVICE_FAMILY = intended_device_family
) (
    input  wire                 clock, clken, aclr,
    input  wire [LPM_WIDTH-1:0] dataa, datab,
    output wire                 alb, aeb, agb, aleb, aneb, ageb
);
    // Signed numbers compare as unsigned ones with the sign turned.
    wire [LPM_WIDTH-1:0] turn = LPM_REPRESENTATION == "SIGNED" ? 1 << (LPM_WIDTH - 1) : 0;
    wire less  = (dataa ^ turn) < (datab ^ turn);
    wire equal = dataa == datab;

    de1sim_pipeline #(.WIDTH(6), .STAGES(LPM_PIPELINE)) pipeline (
        .clock_i(clock), .clken_i(clken), .aclr_i(aclr), .sclr_i(1'b0),
        .d_i({less, equal, !less && !equal, less || equal, !equal, !less}),
        .q_o({alb, aeb, agb, aleb, aneb, ageb}));
// verilator lint_on WIDTH
endmodule

`default_nettype wire
