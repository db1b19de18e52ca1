// lpm_and.v - LPM_SIZE words joined bit by bit: 1 where each of them has a 1

`default_nettype none

module lpm_and #(
    parameter lpm_width = 1, LPM_WIDTH = lpm_width,
    parameter lpm_size = 1, LPM_SIZE = lpm_size,
    // Without meaning here.
    parameter lpm_hint = "UNUSED", LPM_HINT = lpm_hint,
    parameter lpm_type = "lpm_and", LPM_TYPE = lpm_type,
    parameter intended_device_family = "UNUSED", INTENDED_DEVICE_FAMILY = intended_device_family
) (
    input  wire [LPM_SIZE*LPM_WIDTH-1:0] data,     // word 0 lowest
    output wire [LPM_WIDTH-1:0]          result
);
    integer i;
    reg [LPM_WIDTH-1:0] joined;
    always @* begin
        joined = data[LPM_WIDTH-1:0];
        for (i = 1; i < LPM_SIZE; i = i + 1) joined = joined & data[LPM_WIDTH*i +: LPM_WIDTH];
    end
    assign result = joined;
endmodule

`default_nettype wire
