// altera_avalon_sysid_qsys.v - Platform Designer's System ID: two words that are fixed
//
//   0 id, 1 timestamp of the generation
//
// Source: Embedded Peripherals IP User Guide, System ID Peripheral Core.

`default_nettype none

module altera_avalon_sysid_qsys #(
    parameter [31:0] id        = 32'd0,
    parameter [31:0] timestamp = 32'd0
) (
    // verilator lint_off UNUSED
    input  wire        clock,
    input  wire        reset_n,
    // verilator lint_on UNUSED
    input  wire        address,
    output wire [31:0] readdata
);
    assign readdata = address ? timestamp : id;
endmodule

`default_nettype wire
