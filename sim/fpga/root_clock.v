// root_clock.v - in the simulation: a pulse for each change of clk_i
//
// One eval() works off the rising and the falling edge at once: a call per clock, where
// rtl/common/root_clock.v needs two.

`default_nettype none

module root_clock (
    input  wire clk_i,
    output wire clk_o
);
    reg seen_q = 1'b0;

    assign clk_o = clk_i ^ seen_q;
    always @(posedge clk_o) seen_q <= clk_i;
endmodule

`default_nettype wire
