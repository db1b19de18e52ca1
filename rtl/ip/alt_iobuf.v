// alt_iobuf.v - the buffer of a pin that is in and out

`default_nettype none

module alt_iobuf #(
    // Without meaning here.
    parameter io_standard = "NONE", IO_STANDARD = io_standard,
    parameter location = "NONE", LOCATION = location,
    parameter enable_bus_hold = "NONE", ENABLE_BUS_HOLD = enable_bus_hold,
    parameter weak_pull_up_resistor = "NONE", WEAK_PULL_UP_RESISTOR = weak_pull_up_resistor,
    parameter termination = "NONE", TERMINATION = termination,
    parameter current_strength = "NONE", CURRENT_STRENGTH = current_strength,
    parameter current_strength_new = "NONE", CURRENT_STRENGTH_NEW = current_strength_new,
    parameter slew_rate = -1, SLEW_RATE = slew_rate,
    parameter slow_slew_rate = "NONE", SLOW_SLEW_RATE = slow_slew_rate,
    parameter input_termination = "NONE", INPUT_TERMINATION = input_termination,
    parameter output_termination = "NONE", OUTPUT_TERMINATION = output_termination,
    parameter lpm_type = "alt_iobuf", LPM_TYPE = lpm_type
) (
    input  wire i,
    input  wire oe,
    inout  wire io,
    output wire o
);
    assign io = oe ? i : 1'bz;
    assign o = io;
endmodule

`default_nettype wire
