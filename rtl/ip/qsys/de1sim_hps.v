// de1sim_hps.v - of the processor: its reset of the FPGA, and its interrupts from there
//
// It meets the simulated processor in the chip around the design (de1sim_chip.v).

`default_nettype none

module de1sim_hps (
    output wire        h2f_rst_n,
    input  wire [31:0] f2h_irq_p0,  // IDs 72 to 103
    input  wire [31:0] f2h_irq_p1   // IDs 104 to 135
);
`ifdef DE1SIM_LISTS
    // The design alone, without the chip.
    assign h2f_rst_n = 1'b1;
    // verilator lint_off UNUSED
    wire [63:0] irq = {f2h_irq_p1, f2h_irq_p0};
    // verilator lint_on UNUSED
`else
    assign h2f_rst_n           = !de1sim_chip.hps_reset;
    assign de1sim_chip.hps_irq = {f2h_irq_p1, f2h_irq_p0};
`endif
endmodule

`default_nettype wire
