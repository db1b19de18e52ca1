// group_clock.v - the clock of blocks that sleep together: on the device the clock itself
//
// A block says in awake_o whether a clock could change anything in it (README.md, Sleep).  While it
// could not, an additional edge changes nothing, so on the device a wire will do.  The simulation
// has its own version of this file, sim/fpga/group_clock.v, which leaves the edges out.

`default_nettype none

module group_clock (
    input  wire clk_i,
    // Whether the group sleeps makes no difference here.
    // verilator lint_off UNUSED
    input  wire awake_i,
    // verilator lint_on UNUSED
    output wire clk_o
);
    assign clk_o = clk_i;
endmodule

`default_nettype wire
