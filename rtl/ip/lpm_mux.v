// lpm_mux.v - one of LPM_SIZE values, with a pipeline
//
// Value i is data[LPM_WIDTH*i +: LPM_WIDTH].

`default_nettype none
// Texts of different lengths, and parameters with numbers.
// verilator lint_off WIDTH

module lpm_mux #(
    parameter lpm_width = 1, LPM_WIDTH = lpm_width,
    parameter lpm_size = 2, LPM_SIZE = lpm_size,
    parameter lpm_widths = 1, LPM_WIDTHS = lpm_widths,
    parameter lpm_pipeline = 0, LPM_PIPELINE = lpm_pipeline,
    // Without meaning here.
    parameter lpm_hint = "UNUSED", LPM_HINT = lpm_hint,
    parameter lpm_type = "lpm_mux", LPM_TYPE = lpm_type,
    parameter intended_device_family = "UNUSED", INTENDED_DEVICE_FAMILY = intended_device_family
) (
    input  wire                          clock, clken, aclr,
    input  wire [LPM_SIZE*LPM_WIDTH-1:0] data,
    input  wire [LPM_WIDTHS-1:0]         sel,
    output wire [LPM_WIDTH-1:0]          result
);
    de1sim_pipeline #(.WIDTH(LPM_WIDTH), .STAGES(LPM_PIPELINE)) pipeline (
        .clock_i(clock), .clken_i(clken), .aclr_i(aclr), .sclr_i(1'b0),
        .d_i(data[sel * LPM_WIDTH +: LPM_WIDTH]), .q_o(result));
// verilator lint_on WIDTH
endmodule

`default_nettype wire
