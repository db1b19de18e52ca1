// root_clock.v - in the traced simulation: the clock itself where waveforms are wanted
//
// Before that it is a pulse for each change of clk_i, as in sim/fpga/root_clock.v.  every_clock
// rises while clk_i is 0, so that no edge comes of it.

`default_nettype none

module root_clock (
    input  wire clk_i,
    output wire clk_o
);
    reg every_clock /* verilator public_flat_rw */ = 1'b1;
    reg seen_q = 1'b0;

    assign clk_o = every_clock ? clk_i : clk_i ^ seen_q;
    always @(posedge clk_o) seen_q <= clk_i;
endmodule

`default_nettype wire
