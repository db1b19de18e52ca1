// group_clock.v - in the traced simulation: each edge where waveforms are wanted, see root_clock.v

`default_nettype none

module group_clock (
    input  wire clk_i,
    input  wire awake_i,
    output wire clk_o
);
    assign clk_o = clk_i & (awake_i | fpga.clocks.root.every_clock);
endmodule

`default_nettype wire
