// de1sim_pll_tap.v - where an output clock of a PLL comes into the design: a stand-in without clock
//
// Verilog makes no clocks here.  For a project, another file of this module's name connects clk to
// a bit of the wrapper's input, by its parameters; README.md has the contract.

`default_nettype none

module de1sim_pll_tap #(
    parameter [63:0] PERIOD_FS = 64'd0,
    parameter [63:0] PHASE_FS  = 64'd0,  // of a rising edge, below PERIOD_FS
    parameter [63:0] HIGH_FS   = 64'd0,
    parameter [63:0] SETTABLE  = 64'd0   // the clock is not that of others, and changes
) (
    output wire        clk,
    // verilator lint_off UNUSED
    input  wire        set_i,            // rises: from the next edge on it has these
    input  wire [63:0] period_fs_i,
    input  wire [63:0] high_fs_i
    // verilator lint_on UNUSED
);
    assign clk = 1'b0;
endmodule

`default_nettype wire
