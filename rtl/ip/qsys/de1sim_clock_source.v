// de1sim_clock_source.v - Platform Designer's clock_source: a clock and a reset from outside

`default_nettype none

module de1sim_clock_source (
    input  wire in_clk,
    input  wire reset_n,
    output wire clk_out,
    output wire reset_n_out
);
    assign clk_out     = in_clk;
    assign reset_n_out = reset_n;
endmodule

`default_nettype wire
