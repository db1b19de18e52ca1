// cyclonev_hps_interface_interrupts.v - interrupts from the FPGA

`default_nettype none

module cyclonev_hps_interface_interrupts (
    input  wire [63:0] irq  // IDs 72 to 135
);
    // verilator lint_off UNUSED
    wire reset_n;
    // verilator lint_on UNUSED
    de1sim_hps hps (.h2f_rst_n(reset_n), .f2h_irq_p0(irq[31:0]), .f2h_irq_p1(irq[63:32]));
endmodule

`default_nettype wire
