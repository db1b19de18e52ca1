// lw_decode.v - which block gets an access on the lightweight bridge
//
// The addresses are those of regmap.def.  As Platform Designer's interconnect does it, there is a
// block for each access: what no block takes goes to the one with the largest span, of equals to
// the one with the lowest base; so does a write to a block that can only be read.  The address bits
// above those that the blocks need are not looked at.
//
// Source: the DE1-SoC Computer's generated interconnect; Platform Designer User Guide, Accessing
// Undefined Memory Regions.

`default_nettype none

module lw_decode (
    input  wire        clk_i,
    input  wire        rst_i,
    input  wire        enable_i,
    input  wire        write_i,  // constant
    input  wire [20:0] addr_i,   // offset in the bridge's 2 MB
    output reg  [31:0] sel_o,    // one line per block for one clock, SEL_... of regmap.vh
    output wire        awake_o
);
    `include "regmap.vh"
    `include "lw_decode.vh"

    assign awake_o = sel_o != 32'd0;

    always @(posedge clk_i) begin
        sel_o <= 32'd0;
        if (enable_i) sel_o <= line_of(addr_i, write_i);
        if (rst_i) sel_o <= 32'd0;
    end
endmodule

`default_nettype wire
