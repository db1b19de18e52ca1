// cyclonev_hps_interface_peripheral_uart.v - a UART of the processor's, its signals in the FPGA
//
// The modem's signals are low where they are active, as at the UART's own pins; Intel does not say.

`default_nettype none

module cyclonev_hps_interface_peripheral_uart #(
    // The device's primitive has none.
    parameter number = -1, NUMBER = number  // which UART; -1: by the instance's name
) (
    input  wire rxd,
    input  wire cts,
    input  wire dsr,
    input  wire dcd,
    input  wire ri,
    output wire txd,
    output wire dtr,
    output wire rts,
    output wire out1_n,
    output wire out2_n
);
    de1sim_hps_wires #(
        .KIND(0), .NUMBER(NUMBER), .FROM(5), .TO(5), .IDLE(64'h1f)
    ) wires (
        .from_i({ri, dcd, dsr, cts, rxd}), .to_o({out2_n, out1_n, rts, dtr, txd})
    );
endmodule

`default_nettype wire
