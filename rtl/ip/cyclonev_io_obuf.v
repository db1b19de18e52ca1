// cyclonev_io_obuf.v - device primitive: the buffer of an output pin, or of a differential pair
//
// With open_drain_output a 1 is high impedance.

`default_nettype none
// Texts of different lengths.
// verilator lint_off WIDTH

module cyclonev_io_obuf #(
    parameter open_drain_output = "false", OPEN_DRAIN_OUTPUT = open_drain_output,
    // Without meaning here.
    parameter bus_hold = "false", BUS_HOLD = bus_hold,
    parameter shift_series_termination_control = "false",
    parameter SHIFT_SERIES_TERMINATION_CONTROL = shift_series_termination_control,
    parameter sim_dynamic_termination_control_is_connected = "false",
    parameter SIM_DYNAMIC_TERMINATION_CONTROL_IS_CONNECTED =
        sim_dynamic_termination_control_is_connected,
    parameter lpm_type = "cyclonev_io_obuf", LPM_TYPE = lpm_type
) (
    input  wire        i, oe, devoe,
    input  wire        dynamicterminationcontrol,
    input  wire [15:0] seriesterminationcontrol, parallelterminationcontrol,
    output wire        o, obar
);
    wire drives = oe && devoe && (OPEN_DRAIN_OUTPUT == "false" || !i);
    assign o = drives ? i : 1'bz;
    assign obar = oe && devoe ? !i : 1'bz;
// verilator lint_on WIDTH
endmodule

`default_nettype wire
