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
    `include "de1sim_pll.vh"

    reg [4:0] clocks_q;
    assign locked_o = clocks_q[4] && !rst_i;

    initial de1sim_pll_waits(1);
    always @(posedge refclk_i or posedge rst_i)
        if (rst_i) begin
            if (clocks_q[4]) de1sim_pll_waits(1);
            clocks_q <= 5'd0;
        end else if (!clocks_q[4]) begin
            if (clocks_q == 5'd15) de1sim_pll_waits(-1);
            clocks_q <= clocks_q + 5'd1;
        end
endmodule

`default_nettype wire
