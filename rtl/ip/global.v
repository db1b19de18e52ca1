// global.v - primitive: a net of its own, which is a wire
//
// The name is a word of SystemVerilog, so what instantiates it must be Verilog, too.

`default_nettype none
`begin_keywords "1364-2005"

module global (
    input  wire in,
    output wire out
);
    assign out = in;
`end_keywords
endmodule

`default_nettype wire
