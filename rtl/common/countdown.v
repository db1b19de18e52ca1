// countdown.v - a counter that falls to 0 and stays there
//
// In the simulation sim/fpga/countdown.v takes its place, which sleeps while it counts.

`default_nettype none

module countdown #(
    parameter WIDTH = 8
) (
    input  wire             clk_i,
    input  wire             load_i,
    input  wire [WIDTH-1:0] value_i,     // valid with load_i: what it is in the next clock
    input  wire             run_i,       // else it is one less in the next clock
    output wire [WIDTH-1:0] count_o,
    output wire             zero_o,
    output wire             awake_o      // it counts, or its owner acts at 0
);
    reg [WIDTH-1:0] count_q;

    assign count_o = count_q;
    assign zero_o  = count_q == {WIDTH{1'b0}};
    assign awake_o = run_i;

    always @(posedge clk_i)
        if (load_i) count_q <= value_i;
        else if (run_i && !zero_o) count_q <= count_q - 1'b1;
endmodule

`default_nettype wire
