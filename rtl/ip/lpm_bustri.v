// lpm_bustri.v - the buffers of a bus: data to tridata with enabledt, tridata to result with
// enabletr
//
// What is not enabled is high impedance.

`default_nettype none

module lpm_bustri #(
    parameter lpm_width = 1, LPM_WIDTH = lpm_width,
    // Without meaning here.
    parameter lpm_hint = "UNUSED", LPM_HINT = lpm_hint,
    parameter lpm_type = "lpm_bustri", LPM_TYPE = lpm_type,
    parameter intended_device_family = "UNUSED", INTENDED_DEVICE_FAMILY = intended_device_family
) (
    input  wire [LPM_WIDTH-1:0] data,
    input  wire                 enabledt, enabletr,
    output wire [LPM_WIDTH-1:0] result,
    inout  wire [LPM_WIDTH-1:0] tridata
);
    assign tridata = enabledt ? data : {LPM_WIDTH{1'bz}};
    assign result = enabletr ? tridata : {LPM_WIDTH{1'bz}};
endmodule

`default_nettype wire
