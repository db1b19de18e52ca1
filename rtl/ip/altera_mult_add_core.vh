// altera_mult_add_core.vh - how altera_mult_add and altera_mult_add_rtl use de1sim_mult_add
//
// To be included in these modules.

`include "de1sim_line.vh"

de1sim_mult_add #(
    .NUMBER(NUMBER_OF_MULTIPLIERS), .WIDTH_A(WIDTH_A), .WIDTH_B(WIDTH_B), .WIDTH(WIDTH_RESULT),
    .A_CLOCK({de1sim_line(INPUT_REGISTER_A3), de1sim_line(INPUT_REGISTER_A2),
        de1sim_line(INPUT_REGISTER_A1), de1sim_line(INPUT_REGISTER_A0)}),
    .A_ACLR({de1sim_line(INPUT_ACLR_A3), de1sim_line(INPUT_ACLR_A2),
        de1sim_line(INPUT_ACLR_A1), de1sim_line(INPUT_ACLR_A0)}),
    .A_SCLR({de1sim_line(INPUT_SCLR_A3), de1sim_line(INPUT_SCLR_A2),
        de1sim_line(INPUT_SCLR_A1), de1sim_line(INPUT_SCLR_A0)}),
    .B_CLOCK({de1sim_line(INPUT_REGISTER_B3), de1sim_line(INPUT_REGISTER_B2),
        de1sim_line(INPUT_REGISTER_B1), de1sim_line(INPUT_REGISTER_B0)}),
    .B_ACLR({de1sim_line(INPUT_ACLR_B3), de1sim_line(INPUT_ACLR_B2),
        de1sim_line(INPUT_ACLR_B1), de1sim_line(INPUT_ACLR_B0)}),
    .B_SCLR({de1sim_line(INPUT_SCLR_B3), de1sim_line(INPUT_SCLR_B2),
        de1sim_line(INPUT_SCLR_B1), de1sim_line(INPUT_SCLR_B0)}),
    .PRODUCT_CLOCK({de1sim_line(MULTIPLIER_REGISTER3), de1sim_line(MULTIPLIER_REGISTER2),
        de1sim_line(MULTIPLIER_REGISTER1), de1sim_line(MULTIPLIER_REGISTER0)}),
    .PRODUCT_ACLR({de1sim_line(MULTIPLIER_ACLR3), de1sim_line(MULTIPLIER_ACLR2),
        de1sim_line(MULTIPLIER_ACLR1), de1sim_line(MULTIPLIER_ACLR0)}),
    .PRODUCT_SCLR({de1sim_line(MULTIPLIER_SCLR3), de1sim_line(MULTIPLIER_SCLR2),
        de1sim_line(MULTIPLIER_SCLR1), de1sim_line(MULTIPLIER_SCLR0)}),
    .SIGN_A_CLOCK(de1sim_line(SIGNED_REGISTER_A)),
    .SIGN_A_ACLR(de1sim_line(SIGNED_ACLR_A)),
    .SIGN_A_SCLR(de1sim_line(SIGNED_SCLR_A)),
    .SIGN_B_CLOCK(de1sim_line(SIGNED_REGISTER_B)),
    .SIGN_B_ACLR(de1sim_line(SIGNED_ACLR_B)),
    .SIGN_B_SCLR(de1sim_line(SIGNED_SCLR_B)),
    .ADD_1_CLOCK(de1sim_line(ADDNSUB_MULTIPLIER_REGISTER1)),
    .ADD_1_ACLR(de1sim_line(ADDNSUB_MULTIPLIER_ACLR1)),
    .ADD_1_SCLR(de1sim_line(ADDNSUB_MULTIPLIER_SCLR1)),
    .ADD_3_CLOCK(de1sim_line(ADDNSUB_MULTIPLIER_REGISTER3)),
    .ADD_3_ACLR(de1sim_line(ADDNSUB_MULTIPLIER_ACLR3)),
    .ADD_3_SCLR(de1sim_line(ADDNSUB_MULTIPLIER_SCLR3)),
    .RESULT_CLOCK(de1sim_line(OUTPUT_REGISTER)),
    .RESULT_ACLR(de1sim_line(OUTPUT_ACLR)),
    .RESULT_SCLR(de1sim_line(OUTPUT_SCLR)),
    .SCANOUT_CLOCK(de1sim_line(SCANOUTA_REGISTER)),
    .SCANOUT_ACLR(de1sim_line(SCANOUTA_ACLR)),
    .SCANOUT_SCLR(de1sim_line(SCANOUTA_SCLR)),
    .LOAD_CLOCK(de1sim_line(ACCUM_SLOAD_REGISTER)),
    .LOAD_ACLR(de1sim_line(ACCUM_SLOAD_ACLR)),
    .LOAD_SCLR(de1sim_line(ACCUM_SLOAD_SCLR)),
    .LATENCY_CLOCK(de1sim_line(INPUT_A0_LATENCY_CLOCK)),
    .LATENCY_ACLR(de1sim_line(INPUT_A0_LATENCY_ACLR)),
    .LATENCY_SCLR(de1sim_line(INPUT_A0_LATENCY_SCLR)),
    .LATENCY(LATENCY),
    .A_SOURCE({de1sim_source(INPUT_SOURCE_A3), de1sim_source(INPUT_SOURCE_A2),
        de1sim_source(INPUT_SOURCE_A1), de1sim_source(INPUT_SOURCE_A0)}),
    .B_SOURCE({de1sim_source(INPUT_SOURCE_B3), de1sim_source(INPUT_SOURCE_B2),
        de1sim_source(INPUT_SOURCE_B1), de1sim_source(INPUT_SOURCE_B0)}),
    .SIGN_A_PORT(PORT_SIGNA == "PORT_USED"), .SIGN_B_PORT(PORT_SIGNB == "PORT_USED"),
    .SIGNED_A(REPRESENTATION_A == "SIGNED"), .SIGNED_B(REPRESENTATION_B == "SIGNED"),
    .ADD_1_PORT(PORT_ADDNSUB1 == "PORT_USED"), .ADD_3_PORT(PORT_ADDNSUB3 == "PORT_USED"),
    .SUBTRACT_1(MULTIPLIER1_DIRECTION == "SUB"), .SUBTRACT_3(MULTIPLIER3_DIRECTION == "SUB"),
    .ACCUMULATES(ACCUMULATOR == "YES"), .ACCUMULATES_DOWN(ACCUM_DIRECTION == "SUB"),
    .LOADS_LOW(USE_SLOAD_ACCUM_PORT == "YES"), .LOADED_BIT(LOADCONST_VALUE)
) multipliers (
    .clock_i({clock3, clock2, clock1, clock0}), .ena_i({ena3, ena2, ena1, ena0}),
    .aclr_i({aclr3, aclr2, aclr1, aclr0}), .sclr_i({sclr3, sclr2, sclr1, sclr0}),
    .a_i(dataa), .b_i(datab), .scan_a_i(scanina), .scan_b_i(scaninb), .source_a_i(sourcea),
    .source_b_i(sourceb), .scan_a_o(scanouta), .scan_b_o(scanoutb), .sign_a_i(signa),
    .sign_b_i(signb), .add_1_i(addnsub1), .add_3_i(addnsub3),
    .load_i(USE_SLOAD_ACCUM_PORT == "YES" ? sload_accum : accum_sload), .result_o(result));

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
    if (DOUBLE_ACCUM != "NO") begin : lacks_double_accum
        de1sim_lacks_double_accum lacks ();
    end
    if (SYSTOLIC_DELAY1 != "UNREGISTERED") begin : lacks_systolic_delay1
        de1sim_lacks_systolic_delay1 lacks ();
    end
    if (SYSTOLIC_DELAY3 != "UNREGISTERED") begin : lacks_systolic_delay3
        de1sim_lacks_systolic_delay3 lacks ();
    end
    if (PORT_NEGATE != "PORT_UNUSED") begin : lacks_port_negate
        de1sim_lacks_port_negate lacks ();
    end
    if (USE_SUBNADD != "NO") begin : lacks_use_subnadd
        de1sim_lacks_use_subnadd lacks ();
    end
endgenerate
