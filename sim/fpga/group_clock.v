// group_clock.v - in the simulation: no edge for a group that sleeps
//
// awake_i moves only after an edge and while the clock is low, so the gate has no glitch: clk_i is
// low again when Verilator looks at awake_i again (root_clock.v).

`default_nettype none

module group_clock (
    input  wire clk_i,
    input  wire awake_i,
    output wire clk_o
);
    assign clk_o = clk_i & awake_i;
endmodule

`default_nettype wire
