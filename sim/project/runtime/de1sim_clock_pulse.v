// de1sim_clock_pulse.v - a clock of which nothing sees more than its rise, and so has it at each
// change of its input: one evaluation of the model for a period, where a rise and a fall are two
//
// In waveforms the clock is as on the board.

`default_nettype none

module de1sim_clock_pulse (
    input  wire clk_i,
    output wire clk_o
);
`ifdef DE1SIM_TRACE
    assign clk_o = clk_i;
`else
    reg seen_q = 1'b0;

    assign clk_o = clk_i ^ seen_q;
    always @(posedge clk_o) seen_q <= clk_i;
`endif
endmodule

`default_nettype wire
