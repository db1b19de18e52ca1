// altsquare.v - the square of a number, with a pipeline
//
// result has the upper bits of the square where it is narrower.

`default_nettype none
// Texts of different lengths, and parameters with numbers.
// verilator lint_off WIDTH

module altsquare #(
    parameter data_width = 1, DATA_WIDTH = data_width,
    parameter result_width = 1, RESULT_WIDTH = result_width,
    parameter representation = "UNSIGNED", REPRESENTATION = representation,
    parameter pipeline = 0, PIPELINE = pipeline,
    // Without meaning here.
    parameter result_alignment = "LSB", RESULT_ALIGNMENT = result_alignment,
    parameter lpm_hint = "UNUSED", LPM_HINT = lpm_hint,
    parameter lpm_type = "altsquare", LPM_TYPE = lpm_type,
    parameter intended_device_family = "UNUSED", INTENDED_DEVICE_FAMILY = intended_device_family
) (
    input  wire                    clock, ena, aclr, sclr,
    input  wire [DATA_WIDTH-1:0]   data,
    output wire [RESULT_WIDTH-1:0] result
);
    lpm_mult #(
        .LPM_WIDTHA(DATA_WIDTH), .LPM_WIDTHB(DATA_WIDTH), .LPM_WIDTHP(RESULT_WIDTH),
        .LPM_REPRESENTATION(REPRESENTATION), .LPM_PIPELINE(PIPELINE)
    ) square (
        .clock(clock), .clken(ena), .aclr(aclr), .sclr(sclr), .dataa(data), .datab(data),
        .sum(1'b0), .result(result));
// verilator lint_on WIDTH
endmodule

`default_nettype wire
