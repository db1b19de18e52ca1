// de1sim_clock_bridge.v - Platform Designer's altera_clock_bridge: one clock under several names

`default_nettype none

module de1sim_clock_bridge (
    input  wire in_clk,
    output wire out_clk,
    output wire out_clk_1,
    output wire out_clk_2,
    output wire out_clk_3
);
    assign out_clk   = in_clk;
    assign out_clk_1 = in_clk;
    assign out_clk_2 = in_clk;
    assign out_clk_3 = in_clk;
endmodule

`default_nettype wire
