// multipliers_bench.v - products and their sums, at common inputs

`default_nettype none

module multipliers_bench (
    input  wire        clock_i, other_clock_i, enable_i, aclr_i, sclr_i,
    input  wire        signa_i, signb_i, add_1_i, add_3_i, load_i,
    input  wire [35:0] a_i,                    // four of 9 bits
    input  wire [27:0] b_i,                    // four of 7 bits
    input  wire [3:0]  source_i,

    output wire [31:0] nios_o,                 // a clock later
    output wire [17:0] four_o,                 // of ports alone, at once
    output wire [27:0] late_o,                 // signed, three clocks later
    output wire [17:0] fir_o,                  // of the last three numbers of a
    output wire [8:0]  fir_scan_o,
    output wire [17:0] chosen_o,               // the second from its port or the first's
    output wire [19:0] up_o, down_o,           // accumulators
    output wire [15:0] latency_o,              // two clocks before the product, one after it
    output wire [15:0] clocks_o,
    output wire [15:0] wizard_o,
    output wire [17:0] old_o,                  // altmult_add, three clocks later
    output wire [18:0] old_add_o,              // the same, by port
    output wire [17:0] real_o, imag_o, late_real_o, late_imag_o
);
    // As a Nios II has it.
    altera_mult_add nios (
        .aclr0(aclr_i), .clock0(clock_i), .dataa(a_i[15:0]), .datab(b_i[15:0]), .ena0(enable_i),
        .result(nios_o), .signb(signb_i));
    defparam
        nios.addnsub_multiplier_pipeline_aclr1 = "ACLR0",
        nios.addnsub_multiplier_pipeline_register1 = "CLOCK0",
        nios.addnsub_multiplier_register1 = "UNREGISTERED",
        nios.dedicated_multiplier_circuitry = "YES",
        nios.input_register_a0 = "UNREGISTERED",
        nios.input_register_b0 = "UNREGISTERED",
        nios.input_source_a0 = "DATAA",
        nios.input_source_b0 = "DATAB",
        nios.lpm_type = "altera_mult_add",
        nios.multiplier1_direction = "ADD",
        nios.multiplier_aclr0 = "ACLR0",
        nios.multiplier_register0 = "CLOCK0",
        nios.number_of_multipliers = 1,
        nios.output_register = "UNREGISTERED",
        nios.port_addnsub1 = "PORT_UNUSED",
        nios.port_addnsub3 = "PORT_UNUSED",
        nios.port_signa = "PORT_UNUSED",
        nios.port_signb = "PORT_USED",
        nios.representation_a = "UNSIGNED",
        nios.representation_b = "UNSIGNED",
        nios.selected_device_family = "CYCLONEV",
        nios.signed_pipeline_aclr_b = "ACLR0",
        nios.signed_pipeline_register_b = "CLOCK0",
        nios.signed_register_b = "UNREGISTERED",
        nios.width_a = 16,
        nios.width_b = 16,
        nios.width_result = 32;

    altera_mult_add #(
        .NUMBER_OF_MULTIPLIERS(4), .WIDTH_A(9), .WIDTH_B(7), .WIDTH_RESULT(18),
        .PORT_SIGNA("PORT_USED"), .PORT_SIGNB("PORT_USED"), .PORT_ADDNSUB1("PORT_USED"),
        .PORT_ADDNSUB3("PORT_USED")
    ) four (
        .dataa(a_i), .datab(b_i), .signa(signa_i), .signb(signb_i), .addnsub1(add_1_i),
        .addnsub3(add_3_i), .result(four_o));

    altera_mult_add #(
        .NUMBER_OF_MULTIPLIERS(3), .WIDTH_A(9), .WIDTH_B(7), .WIDTH_RESULT(28),
        .REPRESENTATION_A("SIGNED"), .REPRESENTATION_B("SIGNED"), .MULTIPLIER1_DIRECTION("SUB"),
        .MULTIPLIER3_DIRECTION("ADD"),
        .INPUT_REGISTER_A0("CLOCK0"), .INPUT_REGISTER_A1("CLOCK0"), .INPUT_REGISTER_A2("CLOCK0"),
        .INPUT_REGISTER_B0("CLOCK0"), .INPUT_REGISTER_B1("CLOCK0"), .INPUT_REGISTER_B2("CLOCK0"),
        .INPUT_ACLR_A0("ACLR1"), .INPUT_ACLR_B0("ACLR1"),
        .MULTIPLIER_REGISTER0("CLOCK0"), .MULTIPLIER_REGISTER1("CLOCK0"),
        .MULTIPLIER_REGISTER2("CLOCK0"), .MULTIPLIER_SCLR1("SCLR0"),
        .OUTPUT_REGISTER("CLOCK0")
    ) late (
        .clock0(clock_i), .ena0(enable_i), .aclr0(1'b0), .aclr1(aclr_i), .sclr0(sclr_i),
        .dataa(a_i[26:0]), .datab(b_i[20:0]), .result(late_o));

    altera_mult_add #(
        .NUMBER_OF_MULTIPLIERS(3), .WIDTH_A(9), .WIDTH_B(7), .WIDTH_RESULT(18),
        .MULTIPLIER1_DIRECTION("ADD"), .MULTIPLIER3_DIRECTION("ADD"),
        .INPUT_SOURCE_A1("SCANA"), .INPUT_SOURCE_A2("SCANA"),
        .INPUT_REGISTER_A0("CLOCK0"), .INPUT_REGISTER_A1("CLOCK0"), .INPUT_REGISTER_A2("CLOCK0"),
        .SCANOUTA_REGISTER("CLOCK0")
    ) fir (
        .clock0(clock_i), .ena0(enable_i), .dataa({18'd0, a_i[8:0]}), .datab(b_i[20:0]),
        .result(fir_o), .scanouta(fir_scan_o));

    altera_mult_add #(
        .NUMBER_OF_MULTIPLIERS(2), .WIDTH_A(9), .WIDTH_B(7), .WIDTH_RESULT(18),
        .INPUT_SOURCE_A1("VARIABLE"), .INPUT_SOURCE_B1("VARIABLE")
    ) chosen (
        .dataa(a_i[17:0]), .datab(b_i[13:0]), .sourcea(source_i[1:0]), .sourceb(source_i[3:2]),
        .result(chosen_o));

    altera_mult_add #(
        .NUMBER_OF_MULTIPLIERS(1), .WIDTH_A(9), .WIDTH_B(7), .WIDTH_RESULT(20),
        .REPRESENTATION_A("SIGNED"), .REPRESENTATION_B("SIGNED"), .OUTPUT_REGISTER("CLOCK0"),
        .OUTPUT_ACLR("ACLR0"), .ACCUMULATOR("YES"), .ACCUM_SLOAD_REGISTER("CLOCK0"),
        .LOADCONST_VALUE(5)
    ) up (
        .clock0(clock_i), .ena0(enable_i), .aclr0(aclr_i), .dataa(a_i[8:0]), .datab(b_i[6:0]),
        .accum_sload(load_i), .result(up_o));
    altera_mult_add #(
        .NUMBER_OF_MULTIPLIERS(1), .WIDTH_A(9), .WIDTH_B(7), .WIDTH_RESULT(20),
        .OUTPUT_REGISTER("CLOCK0"), .ACCUMULATOR("YES"), .ACCUM_DIRECTION("SUB"),
        .ACCUM_SLOAD_REGISTER("CLOCK0"), .USE_SLOAD_ACCUM_PORT("YES"), .LOADCONST_VALUE(64)
    ) down (
        .clock0(clock_i), .ena0(1'b1), .dataa(a_i[8:0]), .datab(b_i[6:0]), .sload_accum(!load_i),
        .result(down_o));

    altera_mult_add #(
        .WIDTH_A(9), .WIDTH_B(7), .WIDTH_RESULT(16), .LATENCY(2),
        .INPUT_A0_LATENCY_CLOCK("CLOCK0"), .INPUT_B0_LATENCY_CLOCK("CLOCK0"),
        .MULTIPLIER_REGISTER0("CLOCK0")
    ) latency (
        .clock0(clock_i), .ena0(1'b1), .dataa(a_i[8:0]), .datab(b_i[6:0]), .result(latency_o));

    altera_mult_add #(
        .WIDTH_A(9), .WIDTH_B(7), .WIDTH_RESULT(16), .INPUT_REGISTER_A0("CLOCK0"),
        .INPUT_REGISTER_B0("CLOCK2"), .OUTPUT_REGISTER("CLOCK1"), .OUTPUT_ACLR("ACLR3")
    ) clocks (
        .clock0(clock_i), .clock1(other_clock_i), .clock2(clock_i), .ena0(1'b1), .ena1(1'b1),
        .ena2(enable_i), .aclr3(aclr_i), .dataa(a_i[8:0]), .datab(b_i[6:0]), .result(clocks_o));

    // As a wizard writes it for Cyclone V, with some of its parameters.
    altera_mult_add_rtl wizard (
        .chainout_sat_overflow(), .dataa(a_i[17:0]), .datab(b_i[13:0]), .ena0(1'b1), .ena1(1'b1),
        .ena2(1'b1), .ena3(1'b1), .mult0_is_saturated(), .mult1_is_saturated(),
        .mult2_is_saturated(), .mult3_is_saturated(), .overflow(), .result(wizard_o), .scanouta(),
        .scanoutb(), .accum_sload(1'b0), .aclr0(1'b0), .aclr1(1'b0), .aclr2(1'b0), .aclr3(1'b0),
        .addnsub1(1'b1), .addnsub1_round(1'b0), .addnsub3(1'b1), .addnsub3_round(1'b0),
        .chainin({1{1'b0}}), .chainout_round(1'b0), .chainout_saturate(1'b0), .clock0(1'b1),
        .clock1(1'b1), .clock2(1'b1), .clock3(1'b1), .coefsel0({3{1'b0}}), .coefsel1({3{1'b0}}),
        .coefsel2({3{1'b0}}), .coefsel3({3{1'b0}}), .datac({44{1'b0}}), .negate(1'b0),
        .sclr0(1'b0), .sclr1(1'b0), .sclr2(1'b0), .sclr3(1'b0), .signa(1'b0), .signb(1'b0),
        .sload_accum(1'b0), .sourcea({2{1'b0}}), .sourceb({2{1'b0}}), .scanina({9{1'b0}}),
        .scaninb({7{1'b0}}));
    defparam
        wizard.accum_sload_latency_clock = "UNREGISTERED",
        wizard.accum_sload_register = "CLOCK0",
        wizard.accumulator = "NO",
        wizard.addnsub_multiplier_register1 = "CLOCK0",
        wizard.coef0_0 = 0,
        wizard.dedicated_multiplier_circuitry = "AUTO",
        wizard.extra_latency = 0,
        wizard.input_register_a0 = "UNREGISTERED",
        wizard.input_register_a1 = "UNREGISTERED",
        wizard.input_register_a2 = "CLOCK0",
        wizard.input_register_b0 = "UNREGISTERED",
        wizard.input_register_b1 = "UNREGISTERED",
        wizard.latency = 0,
        wizard.loadconst_value = 64,
        wizard.lpm_type = "altera_mult_add_rtl",
        wizard.mult01_saturation_sclr = "ACLR0",
        wizard.multiplier1_direction = "SUB",
        wizard.multiplier3_direction = "ADD",
        wizard.multiplier_register0 = "UNREGISTERED",
        wizard.multiplier_register1 = "UNREGISTERED",
        wizard.number_of_multipliers = 2,
        wizard.output_register = "UNREGISTERED",
        wizard.port_addnsub1 = "PORT_UNUSED",
        wizard.port_signa = "PORT_UNUSED",
        wizard.preadder_mode = "SIMPLE",
        wizard.representation_a = "SIGNED",
        wizard.representation_b = "SIGNED",
        wizard.selected_device_family = "Cyclone V",
        wizard.signed_register_a = "CLOCK0",
        wizard.width_a = 9,
        wizard.width_b = 7,
        wizard.width_c = 22,
        wizard.width_result = 16;

    altmult_add #(
        .NUMBER_OF_MULTIPLIERS(4), .WIDTH_A(9), .WIDTH_B(7), .WIDTH_RESULT(18),
        .REPRESENTATION_A("SIGNED"), .MULTIPLIER1_DIRECTION("SUB")
    ) old (
        .clock0(clock_i), .ena0(enable_i), .aclr3(aclr_i), .dataa(a_i), .datab(b_i),
        .result(old_o));
    altmult_add old_add (
        .clock0(clock_i), .ena0(enable_i), .aclr3(aclr_i), .dataa(a_i[17:0]), .datab(b_i[13:0]),
        .signa(signa_i), .addnsub1(add_1_i), .result(old_add_o));
    defparam
        old_add.intended_device_family = "Cyclone V",
        old_add.lpm_type = "altmult_add",
        old_add.multiplier1_direction = "UNUSED",
        old_add.number_of_multipliers = 2,
        old_add.port_signa = "PORT_USED",
        old_add.representation_b = "SIGNED",
        old_add.width_a = 9,
        old_add.width_b = 7,
        old_add.width_result = 19;

    altmult_complex #(
        .WIDTH_A(9), .WIDTH_B(7), .WIDTH_RESULT(18), .PIPELINE(0)
    ) complex_at_once (
        .dataa_real(a_i[8:0]), .dataa_imag(a_i[17:9]), .datab_real(b_i[6:0]),
        .datab_imag(b_i[13:7]), .result_real(real_o), .result_imag(imag_o));
    altmult_complex complex_late (
        .clock(clock_i), .ena(enable_i), .aclr(aclr_i), .dataa_real(a_i[8:0]),
        .dataa_imag(a_i[17:9]), .datab_real(b_i[6:0]), .datab_imag(b_i[13:7]),
        .result_real(late_real_o), .result_imag(late_imag_o));
    defparam
        complex_late.implementation_style = "AUTO",
        complex_late.pipeline = 3,
        complex_late.representation_a = "UNSIGNED",
        complex_late.representation_b = "SIGNED",
        complex_late.width_a = 9,
        complex_late.width_b = 7,
        complex_late.width_result = 18;
endmodule

`default_nettype wire
