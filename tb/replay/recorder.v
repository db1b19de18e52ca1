// recorder.v - bound to a block in its test: a line a clock, what goes in and what comes out
//
// Inputs, then outputs before the edge and behind it.
// A test makes many models, one after the other.  A line begins with 0 where another begins, whose
// registers hold anything; it is flushed, since Verilator keeps the last model's file open.
`default_nettype none

module recorder #(
    parameter INPUTS = 1,
    parameter OUTPUTS = 1
) (
    input wire               clk_i,
    input wire [INPUTS-1:0]  inputs_i,
    input wire [OUTPUTS-1:0] outputs_i
);
    integer file;
    reg     begun = 1'b0, edges = 1'b0;

    initial file = $fopen("stimuli.txt", "a");
    always @(posedge clk_i) begin
        $fwrite(file, "%b %b %b", begun, inputs_i, outputs_i);
        begun <= 1'b1;
        edges <= !edges;
    end
    always @(edges) if (begun) begin
        $fdisplay(file, " %b", outputs_i);
        $fflush(file);
    end
endmodule

`default_nettype wire
