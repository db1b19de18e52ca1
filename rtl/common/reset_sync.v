// reset_sync.v - a reset from outside: asserted at once, released on a clock edge
//
// rst_o stays high for two clocks after rst_ni has risen, and is never released between edges.

`default_nettype none

module reset_sync (
    input  wire clk_i,
    input  wire rst_ni,  // asynchronous
    output wire rst_o    // active high
);
    reg [1:0] release_q = 2'b00;

    always @(posedge clk_i or negedge rst_ni)
        if (!rst_ni) release_q <= 2'b00;
        else release_q <= {release_q[0], 1'b1};

    assign rst_o = !release_q[1];
endmodule

`default_nettype wire
