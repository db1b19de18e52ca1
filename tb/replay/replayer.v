// replayer.v - drives the recorded inputs into the block; counts outputs that differ from the
// record
//
// An output that is X counts as different.  Not compared: clocks in reset, and those before a
// model's first reset.
`default_nettype none

module replayer;
    `include "dut.vh"   // INPUTS, OUTPUTS, reset, and the block between them, by replay.py

    reg                clk = 1'b0;
    reg                begun, live;   // not a model's first clock; it was in reset once
    reg  [INPUTS-1:0]  inputs;
    reg  [OUTPUTS-1:0] before, after;
    wire [OUTPUTS-1:0] outputs;
    integer            file, compared = 0, differ = 0;

    task compare(input [OUTPUTS-1:0] recorded);
        if (outputs !== recorded) begin
            differ = differ + 1;
            if (differ <= 10)
                $display("clock %0d: inputs %b: %b, recorded %b", compared, inputs, outputs,
                         recorded);
        end
    endtask

    initial begin
        file = $fopen("stimuli.txt", "r");
        while ($fscanf(file, "%b %b %b %b", begun, inputs, before, after) == 4) begin
            #1;
            if (reset) live = 1'b1;
            else if (!begun) live = 1'b0;
            compared = compared + (live && !reset);
            if (live && !reset) compare(before);
            clk = 1'b1;
            #1;
            if (live && !reset) compare(after);
            clk = 1'b0;
        end
        $display("%0d clocks compared, %0d differ", compared, differ);
        $finish;
    end
endmodule

`default_nettype wire
