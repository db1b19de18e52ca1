// altmult_complex.v - the product of two complex numbers, with a pipeline
//
// A narrow result has the lower bits, a wide one is extended by its sign.
//
// Not handled: complex, by which devices later than Cyclone V multiply two pairs of numbers.

`default_nettype none
// Texts of different lengths, and parameters with numbers.
// verilator lint_off WIDTH

module altmult_complex #(
    parameter width_a = 1, WIDTH_A = width_a,
    parameter width_b = 1, WIDTH_B = width_b,
    parameter width_result = 1, WIDTH_RESULT = width_result,
    parameter representation_a = "SIGNED", REPRESENTATION_A = representation_a,
    parameter representation_b = "SIGNED", REPRESENTATION_B = representation_b,
    parameter pipeline = 4, PIPELINE = pipeline,
    // Without meaning here.
    parameter implementation_style = "AUTO", IMPLEMENTATION_STYLE = implementation_style,
    parameter lpm_hint = "UNUSED", LPM_HINT = lpm_hint,
    parameter lpm_type = "altmult_complex", LPM_TYPE = lpm_type,
    parameter intended_device_family = "UNUSED", INTENDED_DEVICE_FAMILY = intended_device_family
) (
    // Also a word of C++, for which Verilator has another name then.
    // verilator lint_off SYMRSVDWORD
    input  wire                    clock, ena, aclr, complex,
    // verilator lint_on SYMRSVDWORD
    input  wire [WIDTH_A-1:0]      dataa_real, dataa_imag,
    input  wire [WIDTH_B-1:0]      datab_real, datab_imag,
    output wire [WIDTH_RESULT-1:0] result_real, result_imag
);
    localparam FULL  = WIDTH_A + WIDTH_B + 1;
    localparam WIDTH = WIDTH_RESULT > FULL ? WIDTH_RESULT : FULL;
    localparam SIGNED_A = REPRESENTATION_A == "SIGNED", SIGNED_B = REPRESENTATION_B == "SIGNED";

    wire [WIDTH-1:0] ar = {{WIDTH{SIGNED_A && dataa_real[WIDTH_A-1]}}, dataa_real};
    wire [WIDTH-1:0] ai = {{WIDTH{SIGNED_A && dataa_imag[WIDTH_A-1]}}, dataa_imag};
    wire [WIDTH-1:0] br = {{WIDTH{SIGNED_B && datab_real[WIDTH_B-1]}}, datab_real};
    wire [WIDTH-1:0] bi = {{WIDTH{SIGNED_B && datab_imag[WIDTH_B-1]}}, datab_imag};
    wire [WIDTH_RESULT-1:0] real_now = ar * br - ai * bi;
    wire [WIDTH_RESULT-1:0] imag_now = ar * bi + ai * br;

    de1sim_pipeline #(.WIDTH(2 * WIDTH_RESULT), .STAGES(PIPELINE)) registers (
        .clock_i(clock), .clken_i(ena), .aclr_i(aclr), .sclr_i(1'b0),
        .d_i({real_now, imag_now}), .q_o({result_real, result_imag}));
// verilator lint_on WIDTH
endmodule

`default_nettype wire
