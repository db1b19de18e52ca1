// cascade.v - primitive: a cascade chain, which is a wire

`default_nettype none

module cascade (
    input  wire in,
    output wire out
);
    assign out = in;
endmodule

`default_nettype wire
