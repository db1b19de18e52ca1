// lpm_constant.v - a number

`default_nettype none
// Texts of different lengths, and parameters with numbers.
// verilator lint_off WIDTH

module lpm_constant #(
    parameter lpm_width = 1, LPM_WIDTH = lpm_width,
    parameter lpm_cvalue = 0, LPM_CVALUE = lpm_cvalue,
    // Without meaning here.
    parameter lpm_strength = "UNUSED", LPM_STRENGTH = lpm_strength,
    parameter lpm_hint = "UNUSED", LPM_HINT = lpm_hint,
    parameter lpm_type = "lpm_constant", LPM_TYPE = lpm_type,
    parameter intended_device_family = "UNUSED", INTENDED_DEVICE_FAMILY = intended_device_family
) (
    output wire [LPM_WIDTH-1:0] result
);
    `include "de1sim_number.vh"

    assign result = de1sim_number(LPM_CVALUE);
// verilator lint_on WIDTH
endmodule

`default_nettype wire
