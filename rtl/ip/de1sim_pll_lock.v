// de1sim_pll_lock.v - when a PLL is locked: after 16 clocks of its reference without reset
//
// On the board it takes up to 1 ms (Cyclone V datasheet, tLOCK), which nobody wants to simulate;
// 16 clocks are more than any synchroniser of the reset behind it has.

`default_nettype none

module de1sim_pll_lock (
    input  wire refclk_i,
    input  wire rst_i,     // asynchronous
    output wire locked_o
);
    reg [4:0] clocks_q;
    assign locked_o = clocks_q[4] && !rst_i;

    always @(posedge refclk_i or posedge rst_i)
        if (rst_i) clocks_q <= 5'd0;
        else if (!clocks_q[4]) clocks_q <= clocks_q + 5'd1;
endmodule

`default_nettype wire
