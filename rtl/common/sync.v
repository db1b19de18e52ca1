// sync.v - two flip-flops that bring asynchronous signals into one clock domain
//
// Bits may arrive one clock apart: for levels, not for counts.

`default_nettype none

module sync #(
    parameter WIDTH = 1
) (
    input  wire             clk_i,
    input  wire [WIDTH-1:0] async_i,
    output reg  [WIDTH-1:0] sync_o,   // two clocks later
    output wire             awake_o   // a level is still on its way
);
    reg [WIDTH-1:0] meta_q;

    assign awake_o = meta_q != sync_o;

    always @(posedge clk_i) begin
        meta_q <= async_i;
        sync_o <= meta_q;
    end
endmodule

`default_nettype wire
