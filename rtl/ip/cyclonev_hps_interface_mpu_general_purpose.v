// cyclonev_hps_interface_mpu_general_purpose.v - signals of the FPGA manager: gpi and gpo

`default_nettype none

module cyclonev_hps_interface_mpu_general_purpose (
    input  wire [31:0] gp_in,   // gpi, 0xFF706014
    output wire [31:0] gp_out   // gpo, 0xFF706010
);
`ifdef DE1SIM_LISTS
    // The design alone, without the chip.
    assign gp_out = 32'd0;
    // verilator lint_off UNUSED
    wire [31:0] unused = gp_in;
    // verilator lint_on UNUSED
`else
    assign gp_out                  = de1sim_chip.hps_gp;
    assign de1sim_chip.hps_fpga_gp = gp_in;
`endif
endmodule

`default_nettype wire
