// altera_mult_add.v - one to four products, added and subtracted, with registers as asked for
//
// result is p0 + p1 + p2 + p3; addnsub1 or multiplier1_direction subtracts p1, and 3 likewise p3.
// Numbers are signed or not by representation_a and _b, or by signa and signb.  A narrow result
// has the lower bits, a wide one is extended by its sign.
//
// As an accumulator it adds to what it had, or to 2**loadconst_value (to 0 where that is outside):
// with accum_sload at 1, or with use_sload_accum_port where sload_accum is 0.  As in the vendor's
// own model these ports have no effect without a register of theirs.
//
// All latency registers have clock and clears of input_a0_latency_clock.  The parameters that end
// in pipeline_register1 and so on are without meaning, as the vendor says of them.
//
// Not handled: the preadder, coefficients, shifting, rounding, saturation, chains, systolic
// registers, double accumulators, negate and subnadd; a design that asks for one is refused.

`default_nettype none
// Texts of different lengths, and parameters with numbers.
// verilator lint_off WIDTH

module altera_mult_add #(
    `include "altera_mult_add_parameters.vh"
) (
    input  wire                                    clock0, clock1, clock2, clock3,
    input  wire                                    ena0, ena1, ena2, ena3,
    input  wire                                    aclr0, aclr1, aclr2, aclr3,
    input  wire                                    sclr0, sclr1, sclr2, sclr3,

    input  wire [NUMBER_OF_MULTIPLIERS*WIDTH_A-1:0] dataa,
    input  wire [NUMBER_OF_MULTIPLIERS*WIDTH_B-1:0] datab,
    input  wire [NUMBER_OF_MULTIPLIERS*WIDTH_C-1:0] datac,
    input  wire                                    signa, signb,
    input  wire [WIDTH_A-1:0]                      scanina,
    input  wire [WIDTH_B-1:0]                      scaninb,
    input  wire [NUMBER_OF_MULTIPLIERS-1:0]        sourcea, sourceb,   // 1 takes the one before
    output wire [WIDTH_A-1:0]                      scanouta,
    output wire [WIDTH_B-1:0]                      scanoutb,

    input  wire                                    addnsub1, addnsub3, // 1 adds
    input  wire                                    accum_sload, sload_accum,
    output wire [WIDTH_RESULT-1:0]                 result,

    // Of what is not modelled.
    input  wire [WIDTH_CHAININ-1:0]                chainin,
    input  wire [2:0]                              coefsel0, coefsel1, coefsel2, coefsel3,
    input  wire                                    mult01_round, mult23_round,
    input  wire                                    mult01_saturation, mult23_saturation,
    input  wire                                    addnsub1_round, addnsub3_round,
    input  wire                                    output_round, output_saturate,
    input  wire                                    chainout_round, chainout_saturate,
    input  wire                                    zero_chainout, zero_loopback,
    input  wire                                    rotate, shift_right, negate,
    output wire                                    overflow, chainout_sat_overflow,
    output wire                                    mult0_is_saturated, mult1_is_saturated,
    output wire                                    mult2_is_saturated, mult3_is_saturated
);
    `include "altera_mult_add_core.vh"
// verilator lint_on WIDTH
endmodule

`default_nettype wire
