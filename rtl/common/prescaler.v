// prescaler.v - a tick in every 32nd clock, the first of them in the first clock after a reset
//
// In the simulation sim/fpga/prescaler.v takes its place, which sleeps while nobody wants a tick.

`default_nettype none

module prescaler (
    input  wire clk_i,
    input  wire rst_i,
    input  wire wanted_i,    // the next tick changes something
    output wire tick_o,
    output wire awake_o
);
    reg [4:0] count_q;

    assign tick_o  = count_q == 5'd0;
    assign awake_o = wanted_i;

    always @(posedge clk_i) count_q <= rst_i ? 5'd0 : count_q + 5'd1;
endmodule

`default_nettype wire
