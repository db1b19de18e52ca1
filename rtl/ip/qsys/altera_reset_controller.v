// altera_reset_controller.v - Platform Designer's reset controller: one reset of up to 16, which
// begins at once and ends with the clock
//
// Source: Quartus Prime User Guide: Platform Designer, Reset Controller.
//
// Not handled: reset requests ahead of a reset; OUTPUT_RESET_SYNC_EDGES other than deassert.

`default_nettype none

module altera_reset_controller (
    input  wire clk,
    input  wire reset_in0, reset_in1, reset_in2, reset_in3, reset_in4, reset_in5, reset_in6,
    input  wire reset_in7, reset_in8, reset_in9, reset_in10, reset_in11, reset_in12, reset_in13,
    input  wire reset_in14, reset_in15,
    output wire reset_out,
    output wire reset_req
);
    wire any = reset_in0 || reset_in1 || reset_in2 || reset_in3 || reset_in4 || reset_in5
               || reset_in6 || reset_in7 || reset_in8 || reset_in9 || reset_in10 || reset_in11
               || reset_in12 || reset_in13 || reset_in14 || reset_in15;

    de1sim_reset ends (.clk_i(clk), .rst_i(any), .rst_o(reset_out));
    assign reset_req = 1'b0;
endmodule

`default_nettype wire
