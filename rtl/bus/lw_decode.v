// lw_decode.v - which block owns an address on the lightweight bridge
//
// The addresses are those of regmap.def.  No line is high for an address that no block owns.

`default_nettype none

module lw_decode (
    input  wire        clk_i,
    input  wire        rst_i,
    input  wire        enable_i,
    input  wire [20:0] addr_i,   // offset in the bridge's 2 MB
    output reg  [31:0] sel_o,    // one line per block for one clock, SEL_... of regmap.vh
    output reg         none_o,   // the last address had no block
    output wire        awake_o
);
    `include "regmap.vh"
    `include "lw_decode.vh"

    assign awake_o = sel_o != 32'd0;

    always @(posedge clk_i) begin
        sel_o <= 32'd0;
        if (enable_i) begin
            sel_o  <= line_of(addr_i);
            none_o <= line_of(addr_i) == 32'd0;
        end
        if (rst_i) sel_o <= 32'd0;
    end
endmodule

`default_nettype wire
