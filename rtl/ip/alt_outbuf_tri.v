// alt_outbuf_tri.v - the buffer of an output pin that can be off

`default_nettype none

module alt_outbuf_tri #(
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
    parameter lpm_type = "alt_outbuf_tri", LPM_TYPE = lpm_type
) (
    input  wire i,
    input  wire oe,
    output wire o
);
    assign o = oe ? i : 1'bz;
endmodule

`default_nettype wire
