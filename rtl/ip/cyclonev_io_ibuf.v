// cyclonev_io_ibuf.v - device primitive: the buffer of an input pin

`default_nettype none

module cyclonev_io_ibuf #(
    // Without meaning here.
    parameter differential_mode = "false", DIFFERENTIAL_MODE = differential_mode,
    parameter bus_hold = "false", BUS_HOLD = bus_hold,
    parameter simulate_z_as = "z", SIMULATE_Z_AS = simulate_z_as,
    parameter lpm_type = "cyclonev_io_ibuf", LPM_TYPE = lpm_type
) (
    input  wire i,
    input  wire ibar,                          // of a differential pair, where it is ~i
    input  wire dynamicterminationcontrol,
    output wire o
);
    assign o = i;
endmodule

`default_nettype wire
