// tick.v - one clock in 2^LOG2, for blocks that look at slow wires

`default_nettype none

module tick #(
    parameter LOG2 = 5
) (
    input  wire clk_i,
    input  wire rst_i,
    output wire tick_o
);
    localparam [LOG2-1:0] ONE = 1;

    reg [LOG2-1:0] count_q;

    assign tick_o = count_q == {LOG2{1'b0}};

    always @(posedge clk_i) count_q <= rst_i ? {LOG2{1'b0}} : count_q + ONE;
endmodule

`default_nettype wire
