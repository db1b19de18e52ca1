// lpm_rom.v - a ROM whose address is registered, by altsyncram
//
// Not handled: an address without register, which Cyclone V has not; memenab, which counts as 1.

`default_nettype none
// Texts of different lengths, and parameters with numbers.
// verilator lint_off WIDTH

module lpm_rom #(
    parameter lpm_width = 1, LPM_WIDTH = lpm_width,
    parameter lpm_widthad = 1, LPM_WIDTHAD = lpm_widthad,
    parameter lpm_numwords = 0, LPM_NUMWORDS = lpm_numwords,
    parameter lpm_file = "UNUSED", LPM_FILE = lpm_file,
    parameter lpm_outdata = "REGISTERED", LPM_OUTDATA = lpm_outdata,
    // Without meaning here.
    parameter lpm_address_control = "REGISTERED", LPM_ADDRESS_CONTROL = lpm_address_control,
    parameter lpm_hint = "UNUSED", LPM_HINT = lpm_hint,
    parameter lpm_type = "lpm_rom", LPM_TYPE = lpm_type,
    parameter intended_device_family = "UNUSED", INTENDED_DEVICE_FAMILY = intended_device_family
) (
    input  wire                   inclock, outclock, memenab,
    input  wire [LPM_WIDTHAD-1:0] address,
    output wire [LPM_WIDTH-1:0]   q
);
    altsyncram #(
        .OPERATION_MODE("ROM"), .WIDTH_A(LPM_WIDTH), .WIDTHAD_A(LPM_WIDTHAD),
        .NUMWORDS_A(LPM_NUMWORDS), .INIT_FILE(LPM_FILE), .CLOCK_ENABLE_INPUT_A("BYPASS"),
        .CLOCK_ENABLE_OUTPUT_A("BYPASS"),
        .OUTDATA_REG_A(LPM_OUTDATA == "REGISTERED" ? "CLOCK1" : "UNREGISTERED")
    ) memory (
        .clock0(inclock), .clock1(outclock), .clocken0(1'b1), .clocken1(1'b1), .clocken2(1'b1),
        .clocken3(1'b1), .aclr0(1'b0), .aclr1(1'b0), .address_a(address), .addressstall_a(1'b0),
        .wren_a(1'b0), .rden_a(1'b1), .byteena_a(1'b1), .data_a({LPM_WIDTH{1'b0}}),
        .q_a(q), .address_b(1'b0), .addressstall_b(1'b0), .wren_b(1'b0), .rden_b(1'b0),
        .byteena_b(1'b1), .data_b(1'b0), .q_b(), .eccstatus());
// verilator lint_on WIDTH
endmodule

`default_nettype wire
