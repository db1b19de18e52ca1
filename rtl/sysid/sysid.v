// sysid.v - which system this is: a name and the hash of its register map

`default_nettype none

module sysid (
    input  wire        clk_i,
    input  wire        re_i,
    // Only the register's offset in the block is used.
    // verilator lint_off UNUSED
    input  wire [11:0] raddr_i,
    // verilator lint_on UNUSED
    output reg  [31:0] rdata_o,
    output wire        awake_o
);
    `include "regmap.vh"

    assign awake_o = rdata_o != 32'd0;

    always @(posedge clk_i) begin
        rdata_o <= 32'd0;
        if (re_i) rdata_o <= raddr_i[2] == SYSID_HASH[2] ? REGMAP_HASH : SYSID_ID_RESET;
    end
endmodule

`default_nettype wire
