// cyclonev_hps_interface_peripheral_nand.v - the NAND flash's controller, in the FPGA
//
// Not handled: the device: its outputs rest.

`default_nettype none

module cyclonev_hps_interface_peripheral_nand (
    // verilator lint_off UNUSED
    input  wire [7:0] adq_in,
    input  wire [3:0] rdy_busy,
    // verilator lint_on UNUSED
    output wire       adq_oe,
    output wire [7:0] adq_out,
    output wire       ale,
    output wire [3:0] cebar,
    output wire       cle,
    output wire       rebar,
    output wire       webar,
    output wire       wpbar
);
    assign adq_oe  = 1'b0;
    assign adq_out = {8{1'b0}};
    assign ale     = 1'b0;
    assign cebar   = {4{1'b1}};
    assign cle     = 1'b0;
    assign rebar   = 1'b1;
    assign webar   = 1'b1;
    assign wpbar   = 1'b1;
endmodule

`default_nettype wire
