// altera_std_synchronizer.v - a chain of flip-flops between two clocks

`default_nettype none

module altera_std_synchronizer #(
    parameter depth = 3, DEPTH = depth,
    parameter rst_value = 0, RST_VALUE = rst_value
) (
    input  wire clk,
    input  wire reset_n,
    input  wire din,
    output wire dout
);
    reg [DEPTH:0] stages_q;  // the newest lowest, the last one unused
    always @(posedge clk or negedge reset_n)
        if (!reset_n) stages_q <= {DEPTH + 1{RST_VALUE != 0}};
        else stages_q <= {stages_q[DEPTH-1:0], din};

    assign dout = stages_q[DEPTH-1];
endmodule

`default_nettype wire
