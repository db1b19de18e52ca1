// altsyncram_bench.v - memories as wizards and people write them, at common inputs

`default_nettype none

module altsyncram_bench (
    input  wire [1:0]  clock_i,
    input  wire [3:0]  clocken_i,
    input  wire [1:0]  aclr_i,
    input  wire [4:0]  address_a_i, address_b_i,
    input  wire        stall_a_i, stall_b_i,
    input  wire        wren_a_i, wren_b_i, rden_a_i, rden_b_i,
    input  wire [3:0]  byteena_a_i,
    input  wire [31:0] data_a_i, data_b_i,

    output wire [7:0]  rom_o,          // words.mif by way of a wizard's file
    output wire [15:0] bytes_o,        // byte enables, an output register with enable and clear
    output wire [7:0]  old_o,          // reads the old data; a clear without output register
    output wire [7:0]  new_o,          // reads the new data; clocken2
    output wire [31:0] wide_o,         // written by 8, read by 32 bits; another clock
    output wire [15:0] true_a_o,       // true dual port of 16 and 8 bits, two clocks
    output wire [7:0]  true_b_o,
    output wire [39:0] hex_o,          // words.hex, two read ports of one clock
    output wire [7:0]  lpm_rom_o,      // words.mif, an output register of the other clock
    output wire [7:0]  lpm_ram_o       // without output register
);
    wizard_rom rom (.address(address_a_i[2:0]), .clock(clock_i[0]), .q(rom_o));

    altsyncram bytes (
        .clock0(clock_i[0]), .clock1(1'b1), .address_a(address_a_i[3:0]), .data_a(data_a_i[15:0]),
        .wren_a(wren_a_i), .byteena_a(byteena_a_i[1:0]), .rden_a(1'b1), .q_a(bytes_o),
        .clocken0(clocken_i[0]), .clocken1(1'b1), .clocken2(1'b1), .clocken3(1'b1),
        .aclr0(aclr_i[0]), .aclr1(1'b0), .addressstall_a(1'b0), .addressstall_b(1'b0),
        .address_b(1'b1), .byteena_b(1'b1), .data_b(1'b1), .rden_b(1'b1), .wren_b(1'b0),
        .q_b(), .eccstatus());
    defparam
        bytes.operation_mode = "SINGLE_PORT",
        bytes.width_a = 16,
        bytes.widthad_a = 4,
        bytes.numwords_a = 16,
        bytes.width_byteena_a = 2,
        bytes.byte_size = 8,
        bytes.clock_enable_input_a = "BYPASS",
        bytes.clock_enable_output_a = "NORMAL",
        bytes.outdata_aclr_a = "CLEAR0",
        bytes.outdata_reg_a = "CLOCK0",
        bytes.lpm_type = "altsyncram",
        bytes.intended_device_family = "Cyclone V",
        bytes.power_up_uninitialized = "FALSE",
        bytes.read_during_write_mode_port_a = "NEW_DATA_NO_NBE_READ",
        bytes.ram_block_type = "M10K";

    altsyncram #(
        .OPERATION_MODE("SINGLE_PORT"), .WIDTH_A(8), .WIDTHAD_A(4), .NUMWORDS_A(16),
        .READ_DURING_WRITE_MODE_PORT_A("OLD_DATA"), .OUTDATA_ACLR_A("CLEAR1"),
        .CLOCK_ENABLE_INPUT_A("NORMAL")
    ) old (
        .clock0(clock_i[0]), .clocken0(clocken_i[0]), .aclr1(aclr_i[1]),
        .address_a(address_a_i[3:0]), .addressstall_a(stall_a_i), .data_a(data_a_i[7:0]),
        .wren_a(wren_a_i), .rden_a(rden_a_i), .byteena_a(byteena_a_i[0]), .q_a(old_o));

    altsyncram #(
        .operation_mode("SINGLE_PORT"), .width_a(8), .WIDTHAD_A(4),
        .clock_enable_input_a("ALTERNATE")
    ) fresh (
        .clock0(clock_i[0]), .clocken2(clocken_i[2]), .address_a(address_a_i[3:0]),
        .data_a(data_a_i[7:0]), .wren_a(wren_a_i), .rden_a(rden_a_i), .byteena_a(1'b1),
        .q_a(new_o));

    altsyncram wide (
        .clock0(clock_i[0]), .clock1(clock_i[1]), .clocken1(clocken_i[1]),
        .address_a(address_a_i), .address_b(address_b_i[2:0]), .addressstall_b(stall_b_i),
        .data_a(data_a_i[7:0]), .wren_a(wren_a_i), .byteena_a(1'b1), .rden_b(rden_b_i),
        .aclr1(aclr_i[1]), .q_b(wide_o));
    defparam
        wide.operation_mode = "DUAL_PORT",
        wide.width_a = 8,
        wide.widthad_a = 5,
        wide.numwords_a = 32,
        wide.width_b = 32,
        wide.widthad_b = 3,
        wide.numwords_b = 8,
        wide.clock_enable_input_a = "BYPASS",
        wide.clock_enable_input_b = "BYPASS",
        wide.clock_enable_output_b = "NORMAL",
        wide.address_reg_b = "CLOCK1",
        wide.outdata_reg_b = "CLOCK1",
        wide.outdata_aclr_b = "CLEAR1",
        wide.init_file = "wide.mif";

    altsyncram both (
        .clock0(clock_i[0]), .clock1(clock_i[1]), .clocken0(1'b1), .clocken1(clocken_i[1]),
        .address_a(address_a_i[2:0]), .address_b(address_b_i[3:0]),
        .data_a(data_a_i[15:0]), .data_b(data_b_i[7:0]), .wren_a(wren_a_i), .wren_b(wren_b_i),
        .byteena_a(byteena_a_i[1:0]), .byteena_b(1'b1), .rden_a(1'b1), .rden_b(rden_b_i),
        .q_a(true_a_o), .q_b(true_b_o));
    defparam
        both.operation_mode = "BIDIR_DUAL_PORT",
        both.width_a = 16,
        both.widthad_a = 3,
        both.numwords_a = 8,
        both.width_byteena_a = 2,
        both.width_b = 8,
        both.widthad_b = 4,
        both.numwords_b = 16,
        both.width_byteena_b = 1,
        both.init_file = "missing.mif",
        both.indata_reg_b = "CLOCK1",
        both.wrcontrol_wraddress_reg_b = "CLOCK1",
        both.read_during_write_mode_mixed_ports = "OLD_DATA",
        both.read_during_write_mode_port_b = "OLD_DATA";

    altsyncram #(
        .OPERATION_MODE("BIDIR_DUAL_PORT"), .WIDTH_A(40), .WIDTHAD_A(2), .WIDTH_B(40),
        .WIDTHAD_B(2), .ADDRESS_REG_B("CLOCK0"), .INIT_FILE("C:\\work\\words.hex"),
        .CLOCK_ENABLE_INPUT_A("BYPASS"), .CLOCK_ENABLE_INPUT_B("BYPASS")
    ) hex (
        .clock0(clock_i[0]), .address_a(2'd0), .address_b(address_b_i[1:0]), .data_a(40'd0),
        .data_b(40'd0), .wren_a(1'b0), .wren_b(1'b0), .rden_a(1'b1), .rden_b(1'b1), .q_b(hex_o));

    lpm_rom #(
        .LPM_WIDTH(8), .LPM_WIDTHAD(3), .LPM_NUMWORDS(6), .LPM_FILE("../words.mif")
    ) old_rom (
        .inclock(clock_i[0]), .outclock(clock_i[1]), .address(address_a_i[2:0]), .q(lpm_rom_o));
    lpm_ram_dq #(.LPM_WIDTH(8), .LPM_WIDTHAD(4), .LPM_OUTDATA("UNREGISTERED")) old_ram (
        .inclock(clock_i[0]), .address(address_a_i[3:0]), .data(data_a_i[7:0]), .we(wren_a_i),
        .q(lpm_ram_o));
endmodule

`default_nettype wire
