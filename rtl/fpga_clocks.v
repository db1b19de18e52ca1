// fpga_clocks.v - a clock for each group of blocks that sleep together: here the clock itself
//
// A block says in awake_o whether the next clock could change anything in it.  While it could not,
// an additional edge changes nothing, so on the device wires do.  In the simulation
// sim/fpga/fpga_clocks.v takes the place of this file and leaves the edges out (SLEEP.md).

`default_nettype none

module fpga_clocks (
    input  wire clk_i,
    // Who sleeps makes no difference here.
    // verilator lint_off UNUSED
    input  wire rst_i,
    input  wire lw_awake_i,       // a block of the group is awake, or another group accesses it
    input  wire h2f_awake_i,
    input  wire memory_awake_i,
    input  wire fetch_awake_i,    // of the memories' group, too
    input  wire audio_awake_i,
    input  wire ports_awake_i,
    input  wire td_awake_i,       // the video decoder's clock could change something
    // verilator lint_on UNUSED

    output wire clk_o,            // of the beam, which never sleeps
    output wire lw_clk_o,
    output wire h2f_clk_o,
    output wire memory_clk_o,
    output wire ports_clk_o,
    output wire audio_clk_o
);
    assign clk_o        = clk_i;
    assign lw_clk_o     = clk_i;
    assign h2f_clk_o    = clk_i;
    assign memory_clk_o = clk_i;
    assign ports_clk_o  = clk_i;
    assign audio_clk_o  = clk_i;
endmodule

`default_nettype wire
