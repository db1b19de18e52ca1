// root_clock.v - for proofs: the clock itself

`default_nettype none

module root_clock (
    input  wire clk_i,
    output wire clk_o
);
    assign clk_o = clk_i;
endmodule

`default_nettype wire
