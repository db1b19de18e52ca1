// cyclonev_hps_interface_peripheral_i2c.v - an I2C controller of the processor's, with its bus in
// the FPGA
//
// The bus is open drain: out_clk and out_data are 1 where the controller pulls SCL and SDA low.

`default_nettype none

module cyclonev_hps_interface_peripheral_i2c #(
    // The device's primitive has none.
    parameter number = -1, NUMBER = number  // which controller; -1: by the instance's name
) (
    input  wire scl,       // as they are on the bus
    input  wire sda,
    output wire out_clk,
    output wire out_data
);
    de1sim_hps_wires #(
        .KIND(1), .NUMBER(NUMBER), .FROM(2), .TO(2)
    ) wires (
        .from_i({sda, scl}), .to_o({out_data, out_clk})
    );
endmodule

`default_nettype wire
