// cyclonev_hps_interface_peripheral_spi_slave.v - an SPI slave of the processor's, its wires in the
// FPGA

`default_nettype none

module cyclonev_hps_interface_peripheral_spi_slave #(
    // The device's primitive has none.
    parameter number = -1, NUMBER = number  // which slave; -1: by the instance's name
) (
    input  wire rxd,       // MOSI
    input  wire ss_in_n,
    input  wire sclk_in,
    output wire txd,       // MISO
    output wire ssi_oe_n   // low while it drives txd
);
    de1sim_hps_wires #(
        .KIND(3), .NUMBER(NUMBER), .FROM(3), .TO(2), .IDLE(64'h2)
    ) wires (
        .from_i({sclk_in, ss_in_n, rxd}), .to_o({ssi_oe_n, txd})
    );
endmodule

`default_nettype wire
