// altera_syncram.v - Intel's RAM and ROM under the name that newer devices have: altsyncram
//
// Not handled: what a Cyclone V has not: addresses of their own for writing (address2_a), the
// synchronous clear (sclr), the ECC encoder's bypass, coherent reads.

`default_nettype none

module altera_syncram #(
    parameter operation_mode = "BIDIR_DUAL_PORT", OPERATION_MODE = operation_mode,
    parameter width_a = 1, WIDTH_A = width_a,
    parameter widthad_a = 1, WIDTHAD_A = widthad_a,
    parameter numwords_a = 0, NUMWORDS_A = numwords_a,
    parameter width_byteena_a = 1, WIDTH_BYTEENA_A = width_byteena_a,
    parameter outdata_reg_a = "UNREGISTERED", OUTDATA_REG_A = outdata_reg_a,
    parameter outdata_aclr_a = "NONE", OUTDATA_ACLR_A = outdata_aclr_a,
    parameter clock_enable_input_a = "NORMAL", CLOCK_ENABLE_INPUT_A = clock_enable_input_a,
    parameter clock_enable_output_a = "NORMAL", CLOCK_ENABLE_OUTPUT_A = clock_enable_output_a,
    parameter read_during_write_mode_port_a = "NEW_DATA_NO_NBE_READ",
    parameter READ_DURING_WRITE_MODE_PORT_A = read_during_write_mode_port_a,
    parameter width_b = 1, WIDTH_B = width_b,
    parameter widthad_b = 1, WIDTHAD_B = widthad_b,
    parameter numwords_b = 0, NUMWORDS_B = numwords_b,
    parameter width_byteena_b = 1, WIDTH_BYTEENA_B = width_byteena_b,
    parameter address_reg_b = "CLOCK1", ADDRESS_REG_B = address_reg_b,
    parameter outdata_reg_b = "UNREGISTERED", OUTDATA_REG_B = outdata_reg_b,
    parameter outdata_aclr_b = "NONE", OUTDATA_ACLR_B = outdata_aclr_b,
    parameter clock_enable_input_b = "NORMAL", CLOCK_ENABLE_INPUT_B = clock_enable_input_b,
    parameter clock_enable_output_b = "NORMAL", CLOCK_ENABLE_OUTPUT_B = clock_enable_output_b,
    parameter read_during_write_mode_port_b = "NEW_DATA_NO_NBE_READ",
    parameter READ_DURING_WRITE_MODE_PORT_B = read_during_write_mode_port_b,
    parameter init_file = "UNUSED", INIT_FILE = init_file,
    parameter init_file_layout = "UNUSED", INIT_FILE_LAYOUT = init_file_layout,
    parameter width_eccstatus = 2, WIDTH_ECCSTATUS = width_eccstatus,
    // Without meaning here.
    parameter address_aclr_a = "NONE", ADDRESS_ACLR_A = address_aclr_a,
    parameter address_aclr_b = "NONE", ADDRESS_ACLR_B = address_aclr_b,
    parameter byte_size = 0, BYTE_SIZE = byte_size,
    parameter byteena_reg_b = "CLOCK1", BYTEENA_REG_B = byteena_reg_b,
    parameter clock_enable_core_a = "USE_INPUT_CLKEN", CLOCK_ENABLE_CORE_A = clock_enable_core_a,
    parameter clock_enable_core_b = "USE_INPUT_CLKEN", CLOCK_ENABLE_CORE_B = clock_enable_core_b,
    parameter ecc_pipeline_stage_enabled = "FALSE",
    parameter ECC_PIPELINE_STAGE_ENABLED = ecc_pipeline_stage_enabled,
    parameter enable_coherent_read = "FALSE", ENABLE_COHERENT_READ = enable_coherent_read,
    parameter enable_ecc = "FALSE", ENABLE_ECC = enable_ecc,
    parameter enable_ecc_encoder_bypass = "FALSE",
    parameter ENABLE_ECC_ENCODER_BYPASS = enable_ecc_encoder_bypass,
    parameter enable_force_to_zero = "FALSE", ENABLE_FORCE_TO_ZERO = enable_force_to_zero,
    parameter implement_in_les = "OFF", IMPLEMENT_IN_LES = implement_in_les,
    parameter indata_reg_b = "CLOCK1", INDATA_REG_B = indata_reg_b,
    parameter intended_device_family = "UNUSED", INTENDED_DEVICE_FAMILY = intended_device_family,
    parameter lpm_hint = "UNUSED", LPM_HINT = lpm_hint,
    parameter lpm_type = "altera_syncram", LPM_TYPE = lpm_type,
    parameter maximum_depth = 0, MAXIMUM_DEPTH = maximum_depth,
    parameter optimization_option = "AUTO", OPTIMIZATION_OPTION = optimization_option,
    parameter outdata_sclr_a = "NONE", OUTDATA_SCLR_A = outdata_sclr_a,
    parameter outdata_sclr_b = "NONE", OUTDATA_SCLR_B = outdata_sclr_b,
    parameter power_up_uninitialized = "FALSE", POWER_UP_UNINITIALIZED = power_up_uninitialized,
    parameter ram_block_type = "AUTO", RAM_BLOCK_TYPE = ram_block_type,
    parameter rdcontrol_reg_b = "CLOCK1", RDCONTROL_REG_B = rdcontrol_reg_b,
    parameter read_during_write_mode_mixed_ports = "DONT_CARE",
    parameter READ_DURING_WRITE_MODE_MIXED_PORTS = read_during_write_mode_mixed_ports,
    parameter sim_show_memory_data_in_port_b_layout = "OFF",
    parameter SIM_SHOW_MEMORY_DATA_IN_PORT_B_LAYOUT = sim_show_memory_data_in_port_b_layout,
    parameter widthad2_a = 1, WIDTHAD2_A = widthad2_a,
    parameter widthad2_b = 1, WIDTHAD2_B = widthad2_b,
    parameter width_eccencparity = 8, WIDTH_ECCENCPARITY = width_eccencparity
) (
    input  wire                          clock0, clock1,
    input  wire                          clocken0, clocken1, clocken2, clocken3,
    input  wire                          aclr0, aclr1,

    input  wire [WIDTHAD_A-1:0]          address_a,
    input  wire                          addressstall_a,
    input  wire                          wren_a, rden_a,
    input  wire [WIDTH_BYTEENA_A-1:0]    byteena_a,
    input  wire [WIDTH_A-1:0]            data_a,
    output wire [WIDTH_A-1:0]            q_a,

    input  wire [WIDTHAD_B-1:0]          address_b,
    input  wire                          addressstall_b,
    input  wire                          wren_b, rden_b,
    input  wire [WIDTH_BYTEENA_B-1:0]    byteena_b,
    input  wire [WIDTH_B-1:0]            data_b,
    output wire [WIDTH_B-1:0]            q_b,

    // verilator lint_off UNUSED
    input  wire                          sclr, eccencbypass,
    input  wire [WIDTH_ECCENCPARITY-1:0] eccencparity,
    input  wire [WIDTHAD2_A-1:0]         address2_a,
    input  wire [WIDTHAD2_B-1:0]         address2_b,
    // verilator lint_on UNUSED
    output wire [WIDTH_ECCSTATUS-1:0]    eccstatus
);
    altsyncram #(
        .OPERATION_MODE(OPERATION_MODE),
        .WIDTH_A(WIDTH_A),
        .WIDTHAD_A(WIDTHAD_A),
        .NUMWORDS_A(NUMWORDS_A),
        .WIDTH_BYTEENA_A(WIDTH_BYTEENA_A),
        .OUTDATA_REG_A(OUTDATA_REG_A),
        .OUTDATA_ACLR_A(OUTDATA_ACLR_A),
        .CLOCK_ENABLE_INPUT_A(CLOCK_ENABLE_INPUT_A),
        .CLOCK_ENABLE_OUTPUT_A(CLOCK_ENABLE_OUTPUT_A),
        .READ_DURING_WRITE_MODE_PORT_A(READ_DURING_WRITE_MODE_PORT_A),
        .WIDTH_B(WIDTH_B),
        .WIDTHAD_B(WIDTHAD_B),
        .NUMWORDS_B(NUMWORDS_B),
        .WIDTH_BYTEENA_B(WIDTH_BYTEENA_B),
        .ADDRESS_REG_B(ADDRESS_REG_B),
        .OUTDATA_REG_B(OUTDATA_REG_B),
        .OUTDATA_ACLR_B(OUTDATA_ACLR_B),
        .CLOCK_ENABLE_INPUT_B(CLOCK_ENABLE_INPUT_B),
        .CLOCK_ENABLE_OUTPUT_B(CLOCK_ENABLE_OUTPUT_B),
        .READ_DURING_WRITE_MODE_PORT_B(READ_DURING_WRITE_MODE_PORT_B),
        .INIT_FILE(INIT_FILE),
        .INIT_FILE_LAYOUT(INIT_FILE_LAYOUT),
        .WIDTH_ECCSTATUS(WIDTH_ECCSTATUS)
    ) ram (
        .clock0(clock0), .clock1(clock1), .clocken0(clocken0), .clocken1(clocken1),
        .clocken2(clocken2), .clocken3(clocken3), .aclr0(aclr0), .aclr1(aclr1),
        .address_a(address_a), .addressstall_a(addressstall_a), .wren_a(wren_a), .rden_a(rden_a),
        .byteena_a(byteena_a), .data_a(data_a), .q_a(q_a), .address_b(address_b),
        .addressstall_b(addressstall_b), .wren_b(wren_b), .rden_b(rden_b), .byteena_b(byteena_b),
        .data_b(data_b), .q_b(q_b), .eccstatus(eccstatus)
    );
endmodule

`default_nettype wire
