// de1sim_reset_bridge.v - Platform Designer's altera_reset_bridge: one reset under several names
//
// Either the ports whose names end in _n are connected, or the others.

`default_nettype none

module de1sim_reset_bridge (
    input  wire clk,
    input  wire in_reset,
    input  wire in_reset_n,
    output wire out_reset,
    output wire out_reset_1,
    output wire out_reset_2,
    output wire out_reset_3,
    output wire out_reset_n,
    output wire out_reset_1_n,
    output wire out_reset_2_n,
    output wire out_reset_3_n
);
    // verilator lint_off UNUSED
    wire clock = clk;
    // verilator lint_on UNUSED
    assign {out_reset, out_reset_1, out_reset_2, out_reset_3} = {4{in_reset}};
    assign {out_reset_n, out_reset_1_n, out_reset_2_n, out_reset_3_n} = {4{in_reset_n}};
endmodule

`default_nettype wire
