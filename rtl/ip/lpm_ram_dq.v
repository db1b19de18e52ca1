// lpm_ram_dq.v - a RAM with a port for both directions, by altsyncram
//
// Not handled: inputs without register, which Cyclone V has not.

`default_nettype none
// Texts of different lengths, and parameters with numbers.
// verilator lint_off WIDTH

module lpm_ram_dq #(
    parameter lpm_width = 1, LPM_WIDTH = lpm_width,
    parameter lpm_widthad = 1, LPM_WIDTHAD = lpm_widthad,
    parameter lpm_numwords = 0, LPM_NUMWORDS = lpm_numwords,
    parameter lpm_file = "UNUSED", LPM_FILE = lpm_file,
    parameter lpm_outdata = "REGISTERED", LPM_OUTDATA = lpm_outdata,
    // Without meaning here.
    parameter lpm_indata = "REGISTERED", LPM_INDATA = lpm_indata,
    parameter lpm_address_control = "REGISTERED", LPM_ADDRESS_CONTROL = lpm_address_control,
    parameter use_eab = "ON", USE_EAB = use_eab,
    parameter lpm_hint = "UNUSED", LPM_HINT = lpm_hint,
    parameter lpm_type = "lpm_ram_dq", LPM_TYPE = lpm_type,
    parameter intended_device_family = "UNUSED", INTENDED_DEVICE_FAMILY = intended_device_family
) (
    input  wire                   inclock, outclock, we,
    input  wire [LPM_WIDTHAD-1:0] address,
    input  wire [LPM_WIDTH-1:0]   data,
    output wire [LPM_WIDTH-1:0]   q
);
    altsyncram #(
        .OPERATION_MODE("SINGLE_PORT"), .WIDTH_A(LPM_WIDTH), .WIDTHAD_A(LPM_WIDTHAD),
        .NUMWORDS_A(LPM_NUMWORDS), .INIT_FILE(LPM_FILE), .CLOCK_ENABLE_INPUT_A("BYPASS"),
        .CLOCK_ENABLE_OUTPUT_A("BYPASS"),
        .OUTDATA_REG_A(LPM_OUTDATA == "REGISTERED" ? "CLOCK1" : "UNREGISTERED")
    ) memory (
        .clock0(inclock), .clock1(outclock), .clocken0(1'b1), .clocken1(1'b1), .clocken2(1'b1),
        .clocken3(1'b1), .aclr0(1'b0), .aclr1(1'b0), .address_a(address), .addressstall_a(1'b0),
        .wren_a(we), .rden_a(1'b1), .byteena_a(1'b1), .data_a(data),
        .q_a(q), .address_b(1'b0), .addressstall_b(1'b0), .wren_b(1'b0), .rden_b(1'b0),
        .byteena_b(1'b1), .data_b(1'b0), .q_b(), .eccstatus());
// verilator lint_on WIDTH
endmodule

`default_nettype wire
