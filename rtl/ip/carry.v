// carry.v - primitive: a carry chain, which is a wire

`default_nettype none

module carry (
    input  wire in,
    output wire out
);
    assign out = in;
endmodule

`default_nettype wire
