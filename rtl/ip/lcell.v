// lcell.v - primitive: a logic cell, which is a wire

`default_nettype none

module lcell (
    input  wire in,
    output wire out
);
    assign out = in;
endmodule

`default_nettype wire
