// altera_avalon_onchip_memory2.v - Platform Designer's On-Chip Memory: RAM or ROM, one port or two
//
// Data are there one or two clocks after the address, by the latency of the port.
//
// Source: Embedded Peripherals IP User Guide, On-Chip Memory (RAM or ROM).
//
// Not handled: ECC, ports of different widths.

`default_nettype none

module altera_avalon_onchip_memory2 #(
    parameter dataWidth            = 32,
    parameter memorySize           = 4096,   // bytes
    parameter writable             = 1,
    parameter slave1Latency        = 1,      // 1 or 2
    parameter slave2Latency        = 1,
    parameter singleClockOperation = 0,
    parameter init_file            = "UNUSED",
    parameter WORDS                = memorySize / (dataWidth / 8),
    parameter ADDRESS              = WORDS > 1 ? $clog2(WORDS) : 1,
    parameter BYTES                = dataWidth / 8
) (
    input  wire                 clk,
    // verilator lint_off UNUSED
    input  wire                 reset,
    input  wire                 reset2,
    // verilator lint_on UNUSED
    input  wire                 reset_req,
    input  wire [ADDRESS-1:0]   address,
    input  wire                 clken,
    input  wire                 chipselect,
    input  wire                 write,
    output wire [dataWidth-1:0] readdata,
    input  wire [dataWidth-1:0] writedata,
    input  wire [BYTES-1:0]     byteenable,
    input  wire                 debugaccess,   // a debugger, which may write a ROM

    input  wire                 clk2,
    input  wire                 reset_req2,
    input  wire [ADDRESS-1:0]   address2,
    input  wire                 clken2,
    input  wire                 chipselect2,
    input  wire                 write2,
    output wire [dataWidth-1:0] readdata2,
    input  wire [dataWidth-1:0] writedata2,
    input  wire [BYTES-1:0]     byteenable2,
    input  wire                 debugaccess2
);
    wire clock2 = singleClockOperation != 0 ? clk : clk2;

    // verilator lint_off PINCONNECTEMPTY
    altsyncram #(
        .operation_mode("BIDIR_DUAL_PORT"), .init_file(init_file),
        .width_a(dataWidth), .widthad_a(ADDRESS), .numwords_a(WORDS), .width_byteena_a(BYTES),
        .outdata_reg_a(slave1Latency == 2 ? "CLOCK0" : "UNREGISTERED"),
        .width_b(dataWidth), .widthad_b(ADDRESS), .numwords_b(WORDS), .width_byteena_b(BYTES),
        .outdata_reg_b(slave2Latency == 2 ? "CLOCK1" : "UNREGISTERED")
    ) memory (
        .clock0(clk), .clocken0(clken && !reset_req), .clocken2(1'b1),
        .address_a(address), .rden_a(1'b1),
        .wren_a(chipselect && write && (writable != 0 || debugaccess)),
        .byteena_a(byteenable), .data_a(writedata), .q_a(readdata), .addressstall_a(1'b0),
        .aclr0(1'b0),
        .clock1(clock2), .clocken1(clken2 && !reset_req2), .clocken3(1'b1),
        .address_b(address2), .rden_b(1'b1),
        .wren_b(chipselect2 && write2 && (writable != 0 || debugaccess2)),
        .byteena_b(byteenable2), .data_b(writedata2), .q_b(readdata2), .addressstall_b(1'b0),
        .aclr1(1'b0), .eccstatus()
    );
    // verilator lint_on PINCONNECTEMPTY
endmodule

`default_nettype wire
