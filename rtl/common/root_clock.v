// root_clock.v - the clock that the groups' come from: on the device a wire
//
// The simulation has its own version of this file, sim/fpga/root_clock.v.

`default_nettype none

module root_clock (
    input  wire clk_i,
    output wire clk_o
);
    assign clk_o = clk_i;
endmodule

`default_nettype wire
