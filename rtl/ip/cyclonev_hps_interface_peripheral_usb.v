// cyclonev_hps_interface_peripheral_usb.v - a USB controller of the processor's, in the FPGA
//
// Not handled: the device: its outputs rest.

`default_nettype none

module cyclonev_hps_interface_peripheral_usb (
    // verilator lint_off UNUSED
    input  wire       clk,
    input  wire [7:0] datain,
    input  wire       dir,
    input  wire       nxt,
    // verilator lint_on UNUSED
    output wire [7:0] data_out_en,
    output wire [7:0] dataout,
    output wire       stp
);
    assign data_out_en = {8{1'b0}};
    assign dataout     = {8{1'b0}};
    assign stp         = 1'b0;
endmodule

`default_nettype wire
