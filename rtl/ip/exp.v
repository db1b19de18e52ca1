// exp.v - primitive: an inverter

`default_nettype none

module exp (
    input  wire in,
    output wire out
);
    assign out = !in;
endmodule

`default_nettype wire
