// lpm_ram_dp.v - a RAM with a port to write and one to read, by altsyncram
//
// Not handled: inputs without register, which Cyclone V has not.

`default_nettype none
// Texts of different lengths, and parameters with numbers.
// verilator lint_off WIDTH

module lpm_ram_dp #(
    parameter lpm_width = 1, LPM_WIDTH = lpm_width,
    parameter lpm_widthad = 1, LPM_WIDTHAD = lpm_widthad,
    parameter lpm_numwords = 0, LPM_NUMWORDS = lpm_numwords,
    parameter lpm_file = "UNUSED", LPM_FILE = lpm_file,
    parameter lpm_outdata = "REGISTERED", LPM_OUTDATA = lpm_outdata,
    // Without meaning here.
    parameter lpm_indata = "REGISTERED", LPM_INDATA = lpm_indata,
    parameter lpm_rdaddress_control = "REGISTERED", LPM_RDADDRESS_CONTROL = lpm_rdaddress_control,
    parameter lpm_wraddress_control = "REGISTERED", LPM_WRADDRESS_CONTROL = lpm_wraddress_control,
    parameter rden_used = "TRUE", RDEN_USED = rden_used,
    parameter use_eab = "ON", USE_EAB = use_eab,
    parameter lpm_hint = "UNUSED", LPM_HINT = lpm_hint,
    parameter lpm_type = "lpm_ram_dp", LPM_TYPE = lpm_type,
    parameter intended_device_family = "UNUSED", INTENDED_DEVICE_FAMILY = intended_device_family
) (
    input  wire                   wrclock, wrclken, wren,
    input  wire [LPM_WIDTHAD-1:0] wraddress,
    input  wire [LPM_WIDTH-1:0]   data,
    input  wire                   rdclock, rdclken, rden,
    input  wire [LPM_WIDTHAD-1:0] rdaddress,
    output wire [LPM_WIDTH-1:0]   q
);
    altsyncram #(
        .OPERATION_MODE("DUAL_PORT"), .WIDTH_A(LPM_WIDTH), .WIDTHAD_A(LPM_WIDTHAD),
        .NUMWORDS_A(LPM_NUMWORDS), .WIDTH_B(LPM_WIDTH), .WIDTHAD_B(LPM_WIDTHAD),
        .NUMWORDS_B(LPM_NUMWORDS), .INIT_FILE(LPM_FILE), .ADDRESS_REG_B("CLOCK1"),
        .OUTDATA_REG_B(LPM_OUTDATA == "REGISTERED" ? "CLOCK1" : "UNREGISTERED")
    ) memory (
        .clock0(wrclock), .clock1(rdclock), .clocken0(wrclken), .clocken1(rdclken),
        .clocken2(1'b1), .clocken3(1'b1), .aclr0(1'b0), .aclr1(1'b0), .address_a(wraddress),
        .addressstall_a(1'b0), .wren_a(wren), .rden_a(1'b1), .byteena_a(1'b1), .data_a(data),
        .q_a(), .address_b(rdaddress), .addressstall_b(1'b0), .wren_b(1'b0), .rden_b(rden),
        .byteena_b(1'b1), .data_b({LPM_WIDTH{1'b0}}), .q_b(q), .eccstatus());
// verilator lint_on WIDTH
endmodule

`default_nettype wire
