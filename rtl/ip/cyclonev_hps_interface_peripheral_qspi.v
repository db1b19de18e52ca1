// cyclonev_hps_interface_peripheral_qspi.v - the QSPI flash's controller, in the FPGA
//
// Not handled: the device: its outputs rest.

`default_nettype none

module cyclonev_hps_interface_peripheral_qspi (
    // verilator lint_off UNUSED
    input  wire       mi0,
    input  wire       mi1,
    input  wire       mi2,
    input  wire       mi3,
    // verilator lint_on UNUSED
    output wire       mo0,
    output wire       mo1,
    output wire       mo2_wpn,
    output wire       mo3_hold,
    output wire [3:0] n_mo_en,
    output wire [3:0] n_ss_out,
    output wire       sclk_out
);
    assign mo0      = 1'b0;
    assign mo1      = 1'b0;
    assign mo2_wpn  = 1'b1;
    assign mo3_hold = 1'b1;
    assign n_mo_en  = {4{1'b1}};
    assign n_ss_out = {4{1'b1}};
    assign sclk_out = 1'b0;
endmodule

`default_nettype wire
