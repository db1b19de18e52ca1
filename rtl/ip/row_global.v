// row_global.v - primitive: a net of its own, which is a wire

`default_nettype none

module row_global (
    input  wire in,
    output wire out
);
    assign out = in;
endmodule

`default_nettype wire
