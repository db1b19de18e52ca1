// timebase.v - numbers the clocks, for all blocks that wait
//
// A block that waits keeps the number of the clock in which it goes on, and compares; so it can
// sleep meanwhile.  skip_i: the number of clocks after this one that are left out, because nothing
// would happen in them.  Only a simulator leaves clocks out; on the device skip_i is 0.

`default_nettype none

module timebase (
    input  wire        clk_i,
    input  wire        rst_i,
    input  wire [9:0]  skip_i,
    output reg  [29:0] now_o     // 0 in the first clock after a reset
);
    always @(posedge clk_i) now_o <= rst_i ? 30'd0 : now_o + 30'd1 + {20'd0, skip_i};
endmodule

`default_nettype wire
