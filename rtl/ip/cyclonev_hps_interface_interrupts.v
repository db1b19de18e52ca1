// cyclonev_hps_interface_interrupts.v - interrupts from the FPGA

`default_nettype none

module cyclonev_hps_interface_interrupts (
    input  wire [63:0] irq  // IDs 72 to 135
);
`ifdef DE1SIM_LISTS
    // The design alone, without the chip.
    // verilator lint_off UNUSED
    wire [63:0] unused = irq;
    // verilator lint_on UNUSED
`else
    assign de1sim_chip.hps_irq = irq;
`endif
endmodule

`default_nettype wire
