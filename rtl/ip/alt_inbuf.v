// alt_inbuf.v - the buffer of an input pin

`default_nettype none

module alt_inbuf #(
    // Without meaning here.
    parameter io_standard = "NONE", IO_STANDARD = io_standard,
    parameter location = "NONE", LOCATION = location,
    parameter enable_bus_hold = "NONE", ENABLE_BUS_HOLD = enable_bus_hold,
    parameter weak_pull_up_resistor = "NONE", WEAK_PULL_UP_RESISTOR = weak_pull_up_resistor,
    parameter termination = "NONE", TERMINATION = termination,
    parameter lpm_type = "alt_inbuf", LPM_TYPE = lpm_type
) (
    input  wire i,
    output wire o
);
    assign o = i;
endmodule

`default_nettype wire
