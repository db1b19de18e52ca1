// output_port.v - one register that drives pins and reads back: LEDs, 7-segment digits

`default_nettype none

module output_port #(
    parameter [31:0] BITS = 32'h0000_03ff   // the bits that exist
) (
    input  wire        clk_i,
    input  wire        rst_i,

    input  wire        we_i,
    input  wire [3:0]  wstrb_i,
    // Only the register's offset in the block is used.
    // verilator lint_off UNUSED
    input  wire [11:0] waddr_i,
    input  wire [11:0] raddr_i,
    // verilator lint_on UNUSED
    input  wire [31:0] wdata_i,
    input  wire        re_i,
    output reg  [31:0] rdata_o,

    output reg  [31:0] pins_o,
    output wire        awake_o
);
    `include "lanes.vh"

    assign awake_o = rdata_o != 32'd0;

    always @(posedge clk_i) begin
        rdata_o <= re_i && raddr_i[3:0] == 4'd0 ? pins_o : 32'd0;
        if (we_i && waddr_i[3:0] == 4'd0) pins_o <= merged(pins_o, wdata_i, wstrb_i) & BITS;
        if (rst_i) pins_o <= 32'd0;
    end
endmodule

`default_nettype wire
