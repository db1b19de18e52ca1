// lpm_clshift.v - a number shifted or rotated by as many bits as distance says, with a pipeline
//
// To the left with direction 0, to the right with 1.  LOGICAL shifts zeros in, ARITHMETIC the
// sign from the left, ROTATE what left at the other end.  overflow says of a shift to the left
// that a 1 was lost, or with ARITHMETIC that the number does not fit; underflow says of one to the
// right that a 1 was lost, also with ARITHMETIC.  Both are 0 with ROTATE.

`default_nettype none
// Texts of different lengths, and parameters with numbers.
// verilator lint_off WIDTH

module lpm_clshift #(
    parameter lpm_width = 1, LPM_WIDTH = lpm_width,
    parameter lpm_widthdist = 1, LPM_WIDTHDIST = lpm_widthdist,
    parameter lpm_shifttype = "LOGICAL", LPM_SHIFTTYPE = lpm_shifttype,
    parameter lpm_pipeline = 0, LPM_PIPELINE = lpm_pipeline,
    // Without meaning here.
    parameter lpm_hint = "UNUSED", LPM_HINT = lpm_hint,
    parameter lpm_type = "lpm_clshift", LPM_TYPE = lpm_type,
    parameter intended_device_family = "UNUSED", INTENDED_DEVICE_FAMILY = intended_device_family
) (
    input  wire                     clock, clken, aclr,
    input  wire [LPM_WIDTH-1:0]     data,
    input  wire [LPM_WIDTHDIST-1:0] distance,
    input  wire                     direction,
    output wire [LPM_WIDTH-1:0]     result,
    output wire                     overflow, underflow
);
    localparam ROTATE = LPM_SHIFTTYPE == "ROTATE";
    localparam ARITHMETIC = LPM_SHIFTTYPE == "ARITHMETIC";

    wire sign = ARITHMETIC && data[LPM_WIDTH-1];
    wire [31:0] far  = ROTATE ? distance % LPM_WIDTH : distance;
    wire [31:0] back = ROTATE ? LPM_WIDTH - far : LPM_WIDTH;

    // What is shifted out of a word, and what stays: with the sign, and on both sides a whole word.
    wire [2*LPM_WIDTH-1:0] left  = {{LPM_WIDTH{sign}}, data} << far;
    wire [2*LPM_WIDTH-1:0] right = {data, {LPM_WIDTH{1'b0}}} >> far
                                 | (sign ? ~({2*LPM_WIDTH{1'b1}} >> far) : 0);
    wire [LPM_WIDTH-1:0] stays   = direction ? right[2*LPM_WIDTH-1:LPM_WIDTH] : left[LPM_WIDTH-1:0];
    wire [LPM_WIDTH-1:0] rotated = direction ? data >> far | data << back
                                             : data << far | data >> back;

    // A shift to the left has lost nothing where one back gives the number again.
    wire signed [LPM_WIDTH-1:0] signed_stays = stays;
    wire [LPM_WIDTH-1:0] signed_again = signed_stays >>> far;
    wire [LPM_WIDTH-1:0] again = direction ? stays << far
                               : ARITHMETIC ? signed_again : stays >> far;
    wire lost = !ROTATE && again != data;

    de1sim_pipeline #(.WIDTH(LPM_WIDTH + 2), .STAGES(LPM_PIPELINE)) registers (
        .clock_i(clock), .clken_i(clken), .aclr_i(aclr), .sclr_i(1'b0),
        .d_i({lost && !direction, lost && direction, ROTATE ? rotated : stays}),
        .q_o({overflow, underflow, result}));
// verilator lint_on WIDTH
endmodule

`default_nettype wire
