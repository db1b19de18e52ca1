// TRI.v - primitive: an output that can be off

`default_nettype none

module TRI (
    input  wire in,
    input  wire oe,
    output wire out
);
    assign out = oe ? in : 1'bz;
endmodule

`default_nettype wire
