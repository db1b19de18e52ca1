// recorder.v - bound to a block in its test: records inputs and outputs, one line per clock
//
// A line has the inputs, then the outputs before the edge and after it.  A test makes many models,
// one after the other.  The first line of a model, whose registers have random values, begins with
// 0.  Each line is flushed, because Verilator keeps the last model's file open.
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
