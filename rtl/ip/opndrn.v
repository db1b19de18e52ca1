// opndrn.v - primitive: an output that only pulls down

`default_nettype none

module opndrn (
    input  wire in,
    output wire out
);
    assign out = in ? 1'bz : 1'b0;
endmodule

`default_nettype wire
