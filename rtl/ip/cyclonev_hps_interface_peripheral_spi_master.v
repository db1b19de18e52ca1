// cyclonev_hps_interface_peripheral_spi_master.v - an SPI master of the processor's, with its wires
// in the FPGA
//
// Not handled: another master, by ss_in_n.

`default_nettype none

module cyclonev_hps_interface_peripheral_spi_master #(
    // The device's primitive has none.
    parameter number = -1, NUMBER = number  // which master; -1: by the instance's name
) (
    input  wire rxd,       // MISO
    // verilator lint_off UNUSED
    input  wire ss_in_n,
    // verilator lint_on UNUSED
    output wire txd,       // MOSI
    output wire ssi_oe_n,  // low while it sends
    output wire ss_0_n,
    output wire ss_1_n,
    output wire ss_2_n,
    output wire ss_3_n,
    output wire sclk_out
);
    de1sim_hps_wires #(
        .KIND(2), .NUMBER(NUMBER), .FROM(1), .TO(7), .IDLE(64'h7c)
    ) wires (
        .from_i(rxd), .to_o({ss_3_n, ss_2_n, ss_1_n, ss_0_n, ssi_oe_n, sclk_out, txd})
    );
endmodule

`default_nettype wire
