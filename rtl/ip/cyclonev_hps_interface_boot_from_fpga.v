// cyclonev_hps_interface_boot_from_fpga.v - where the processor boots from: not from the FPGA

`default_nettype none

module cyclonev_hps_interface_boot_from_fpga (
    // verilator lint_off UNUSED
    input  wire       boot_from_fpga_ready,
    input  wire       boot_from_fpga_on_failure,
    input  wire [2:0] bsel,
    input  wire       bsel_en,
    input  wire [1:0] csel,
    input  wire       csel_en
    // verilator lint_on UNUSED
);
endmodule

`default_nettype wire
