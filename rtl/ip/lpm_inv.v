// lpm_inv.v - each bit turned

`default_nettype none

module lpm_inv #(
    parameter lpm_width = 1, LPM_WIDTH = lpm_width,
    // Without meaning here.
    parameter lpm_hint = "UNUSED", LPM_HINT = lpm_hint,
    parameter lpm_type = "lpm_inv", LPM_TYPE = lpm_type,
    parameter intended_device_family = "UNUSED", INTENDED_DEVICE_FAMILY = intended_device_family
) (
    input  wire [LPM_WIDTH-1:0] data,
    output wire [LPM_WIDTH-1:0] result
);
    assign result = ~data;
endmodule

`default_nettype wire
