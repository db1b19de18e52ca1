// lpm_decode.v - one bit of LPM_DECODES set, with a pipeline

`default_nettype none
// Texts of different lengths, and parameters with numbers.
// verilator lint_off WIDTH

module lpm_decode #(
    parameter lpm_width = 1, LPM_WIDTH = lpm_width,
    parameter lpm_decodes = 1 << LPM_WIDTH, LPM_DECODES = lpm_decodes,
    parameter lpm_pipeline = 0, LPM_PIPELINE = lpm_pipeline,
    // Without meaning here.
    parameter lpm_hint = "UNUSED", LPM_HINT = lpm_hint,
    parameter lpm_type = "lpm_decode", LPM_TYPE = lpm_type,
    parameter intended_device_family = "UNUSED", INTENDED_DEVICE_FAMILY = intended_device_family
) (
    input  wire                   clock, clken, aclr,
    input  wire                   enable,
    input  wire [LPM_WIDTH-1:0]   data,
    output wire [LPM_DECODES-1:0] eq
);
    wire [LPM_DECODES-1:0] one = enable;

    de1sim_pipeline #(.WIDTH(LPM_DECODES), .STAGES(LPM_PIPELINE)) pipeline (
        .clock_i(clock), .clken_i(clken), .aclr_i(aclr), .sclr_i(1'b0), .d_i(one << data),
        .q_o(eq));
// verilator lint_on WIDTH
endmodule

`default_nettype wire
