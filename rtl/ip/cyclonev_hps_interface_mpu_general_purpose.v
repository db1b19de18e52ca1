// cyclonev_hps_interface_mpu_general_purpose.v - signals of the FPGA manager: all are 0

`default_nettype none

module cyclonev_hps_interface_mpu_general_purpose (
    // verilator lint_off UNUSED
    input  wire [31:0] gp_in,
    output wire [31:0] gp_out
    // verilator lint_on UNUSED
);
    assign gp_out = 32'd0;
endmodule

`default_nettype wire
