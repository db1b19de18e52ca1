// altmult_add.v - one to four products, added and subtracted, with registers as asked for
//
// result is p0 + p1 + p2 + p3; addnsub1 or multiplier1_direction subtracts p1, and 3 likewise p3.
// Numbers are signed or not by representation_a and _b, or by signa and signb.  The port counts
// where port_addnsub1 and so on are PORT_USED, and with PORT_CONNECTIVITY where the parameter is
// UNUSED.  A narrow result has the lower bits, a wide one is extended by its sign.
//
// extra_latency comes after the registers of the operands, with clock0.
//
// Not handled: the accumulator, the preadder, coefficients, shifting, rounding, saturation, chains
// and systolic registers; a design that asks for one is refused.

`default_nettype none
// Texts of different lengths, and parameters with numbers.
// verilator lint_off WIDTH

module altmult_add #(
    `include "altmult_add_parameters.vh"
) (
    input  wire                                    clock0, clock1, clock2, clock3,
    input  wire                                    ena0, ena1, ena2, ena3,
    input  wire                                    aclr0, aclr1, aclr2, aclr3,

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
    output wire [WIDTH_RESULT-1:0]                 result,

    // Of what is not modelled.
    input  wire                                    accum_sload,
    input  wire [WIDTH_CHAININ-1:0]                chainin,
    input  wire [2:0]                              coefsel0, coefsel1, coefsel2, coefsel3,
    input  wire                                    mult01_round, mult23_round,
    input  wire                                    mult01_saturation, mult23_saturation,
    input  wire                                    addnsub1_round, addnsub3_round,
    input  wire                                    output_round, output_saturate,
    input  wire                                    chainout_round, chainout_saturate,
    input  wire                                    zero_chainout, zero_loopback,
    input  wire                                    rotate, shift_right,
    output wire                                    overflow, chainout_sat_overflow,
    output wire                                    mult0_is_saturated, mult1_is_saturated,
    output wire                                    mult2_is_saturated, mult3_is_saturated
);
    `include "de1sim_line.vh"

    function by_port(input [8*20-1:0] port, input [8*20-1:0] value);
        by_port = port == "PORT_USED" || port == "PORT_CONNECTIVITY" && value == "UNUSED";
    endfunction

    de1sim_mult_add #(
        .NUMBER(NUMBER_OF_MULTIPLIERS), .WIDTH_A(WIDTH_A), .WIDTH_B(WIDTH_B), .WIDTH(WIDTH_RESULT),
        .A_CLOCK({de1sim_line(INPUT_REGISTER_A3), de1sim_line(INPUT_REGISTER_A2),
            de1sim_line(INPUT_REGISTER_A1), de1sim_line(INPUT_REGISTER_A0)}),
        .A_ACLR({de1sim_line(INPUT_ACLR_A3), de1sim_line(INPUT_ACLR_A2),
            de1sim_line(INPUT_ACLR_A1), de1sim_line(INPUT_ACLR_A0)}),
        .B_CLOCK({de1sim_line(INPUT_REGISTER_B3), de1sim_line(INPUT_REGISTER_B2),
            de1sim_line(INPUT_REGISTER_B1), de1sim_line(INPUT_REGISTER_B0)}),
        .B_ACLR({de1sim_line(INPUT_ACLR_B3), de1sim_line(INPUT_ACLR_B2),
            de1sim_line(INPUT_ACLR_B1), de1sim_line(INPUT_ACLR_B0)}),
        .PRODUCT_CLOCK({de1sim_line(MULTIPLIER_REGISTER3), de1sim_line(MULTIPLIER_REGISTER2),
            de1sim_line(MULTIPLIER_REGISTER1), de1sim_line(MULTIPLIER_REGISTER0)}),
        .PRODUCT_ACLR({de1sim_line(MULTIPLIER_ACLR3), de1sim_line(MULTIPLIER_ACLR2),
            de1sim_line(MULTIPLIER_ACLR1), de1sim_line(MULTIPLIER_ACLR0)}),
        .SIGN_A_CLOCK(de1sim_line(SIGNED_REGISTER_A)),
        .SIGN_A_ACLR(de1sim_line(SIGNED_ACLR_A)),
        .SIGN_B_CLOCK(de1sim_line(SIGNED_REGISTER_B)),
        .SIGN_B_ACLR(de1sim_line(SIGNED_ACLR_B)),
        .ADD_1_CLOCK(de1sim_line(ADDNSUB_MULTIPLIER_REGISTER1)),
        .ADD_1_ACLR(de1sim_line(ADDNSUB_MULTIPLIER_ACLR1)),
        .ADD_3_CLOCK(de1sim_line(ADDNSUB_MULTIPLIER_REGISTER3)),
        .ADD_3_ACLR(de1sim_line(ADDNSUB_MULTIPLIER_ACLR3)),
        .RESULT_CLOCK(de1sim_line(OUTPUT_REGISTER)),
        .RESULT_ACLR(de1sim_line(OUTPUT_ACLR)),
        .SCANOUT_CLOCK(de1sim_line(SCANOUTA_REGISTER)),
        .SCANOUT_ACLR(de1sim_line(SCANOUTA_ACLR)),
        .ADD_1_LATER_CLOCK(de1sim_line(ADDNSUB_MULTIPLIER_PIPELINE_REGISTER1)),
        .ADD_1_LATER_ACLR(de1sim_line(ADDNSUB_MULTIPLIER_PIPELINE_ACLR1)),
        .ADD_3_LATER_CLOCK(de1sim_line(ADDNSUB_MULTIPLIER_PIPELINE_REGISTER3)),
        .ADD_3_LATER_ACLR(de1sim_line(ADDNSUB_MULTIPLIER_PIPELINE_ACLR3)),
        .LATENCY(EXTRA_LATENCY), .LATENCY_CLOCK(3'd0), .LATENCY_ACLR(de1sim_line(OUTPUT_ACLR)),
        .A_SOURCE({de1sim_source(INPUT_SOURCE_A3), de1sim_source(INPUT_SOURCE_A2),
            de1sim_source(INPUT_SOURCE_A1), de1sim_source(INPUT_SOURCE_A0)}),
        .B_SOURCE({de1sim_source(INPUT_SOURCE_B3), de1sim_source(INPUT_SOURCE_B2),
            de1sim_source(INPUT_SOURCE_B1), de1sim_source(INPUT_SOURCE_B0)}),
        .SIGN_A_PORT(by_port(PORT_SIGNA, REPRESENTATION_A)),
        .SIGN_B_PORT(by_port(PORT_SIGNB, REPRESENTATION_B)),
        .SIGNED_A(REPRESENTATION_A == "SIGNED"), .SIGNED_B(REPRESENTATION_B == "SIGNED"),
        .ADD_1_PORT(by_port(PORT_ADDNSUB1, MULTIPLIER1_DIRECTION)),
        .ADD_3_PORT(by_port(PORT_ADDNSUB3, MULTIPLIER3_DIRECTION)),
        .SUBTRACT_1(MULTIPLIER1_DIRECTION == "SUB"), .SUBTRACT_3(MULTIPLIER3_DIRECTION == "SUB")
    ) multipliers (
        .clock_i({clock3, clock2, clock1, clock0}), .ena_i({ena3, ena2, ena1, ena0}),
        .aclr_i({aclr3, aclr2, aclr1, aclr0}), .sclr_i(4'd0),
        .a_i(dataa), .b_i(datab), .scan_a_i(scanina), .scan_b_i(scaninb), .source_a_i(sourcea),
        .source_b_i(sourceb), .scan_a_o(scanouta), .scan_b_o(scanoutb), .sign_a_i(signa),
        .sign_b_i(signb), .add_1_i(addnsub1), .add_3_i(addnsub3),
        .load_i(1'b0), .result_o(result));

    assign overflow = 1'b0;
    assign chainout_sat_overflow = 1'b0;
    assign mult0_is_saturated = 1'b0;
    assign mult1_is_saturated = 1'b0;
    assign mult2_is_saturated = 1'b0;
    assign mult3_is_saturated = 1'b0;

    // What is missing here, by a name that Verilator's message then has.
    generate
        if (PREADDER_MODE != "SIMPLE") begin : lacks_preadder_mode
            de1sim_lacks_preadder_mode lacks ();
        end
        if (SHIFT_MODE != "NO") begin : lacks_shift_mode
            de1sim_lacks_shift_mode lacks ();
        end
        if (OUTPUT_ROUNDING != "NO") begin : lacks_output_rounding
            de1sim_lacks_output_rounding lacks ();
        end
        if (OUTPUT_SATURATION != "NO") begin : lacks_output_saturation
            de1sim_lacks_output_saturation lacks ();
        end
        if (CHAINOUT_ADDER != "NO") begin : lacks_chainout_adder
            de1sim_lacks_chainout_adder lacks ();
        end
        if (MULTIPLIER01_ROUNDING != "NO") begin : lacks_multiplier01_rounding
            de1sim_lacks_multiplier01_rounding lacks ();
        end
        if (MULTIPLIER23_ROUNDING != "NO") begin : lacks_multiplier23_rounding
            de1sim_lacks_multiplier23_rounding lacks ();
        end
        if (MULTIPLIER01_SATURATION != "NO") begin : lacks_multiplier01_saturation
            de1sim_lacks_multiplier01_saturation lacks ();
        end
        if (MULTIPLIER23_SATURATION != "NO") begin : lacks_multiplier23_saturation
            de1sim_lacks_multiplier23_saturation lacks ();
        end
        if (ADDER1_ROUNDING != "NO") begin : lacks_adder1_rounding
            de1sim_lacks_adder1_rounding lacks ();
        end
        if (ADDER3_ROUNDING != "NO") begin : lacks_adder3_rounding
            de1sim_lacks_adder3_rounding lacks ();
        end
        if (CHAINOUT_ROUNDING != "NO") begin : lacks_chainout_rounding
            de1sim_lacks_chainout_rounding lacks ();
        end
        if (CHAINOUT_SATURATION != "NO") begin : lacks_chainout_saturation
            de1sim_lacks_chainout_saturation lacks ();
        end
        if (ACCUMULATOR != "NO") begin : lacks_accumulator
            de1sim_lacks_accumulator lacks ();
        end
        if (SYSTOLIC_DELAY1 != "UNREGISTERED") begin : lacks_systolic_delay1
            de1sim_lacks_systolic_delay1 lacks ();
        end
        if (SYSTOLIC_DELAY3 != "UNREGISTERED") begin : lacks_systolic_delay3
            de1sim_lacks_systolic_delay3 lacks ();
        end
    endgenerate
// verilator lint_on WIDTH
endmodule

`default_nettype wire
