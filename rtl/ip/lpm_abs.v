// lpm_abs.v - the absolute value of a signed number
//
// The most negative number is its own absolute value; overflow says so.

`default_nettype none

module lpm_abs #(
    parameter lpm_width = 1, LPM_WIDTH = lpm_width,
    // Without meaning here.
    parameter lpm_hint = "UNUSED", LPM_HINT = lpm_hint,
    parameter lpm_type = "lpm_abs", LPM_TYPE = lpm_type,
    parameter intended_device_family = "UNUSED", INTENDED_DEVICE_FAMILY = intended_device_family
) (
    input  wire [LPM_WIDTH-1:0] data,
    output wire [LPM_WIDTH-1:0] result,
    output wire                 overflow
);
    assign result = data[LPM_WIDTH-1] ? -data : data;
    assign overflow = result[LPM_WIDTH-1];
endmodule

`default_nettype wire
