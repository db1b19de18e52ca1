// parallel_ports.v - the DE1-SoC Computer's parallel ports: LEDR, HEX, SW, KEY, JP1, JP2
//
// we_i, re_i: the lines of all blocks, SEL_... of regmap.vh.

`default_nettype none

module parallel_ports (
    input  wire        clk_i,
    input  wire        rst_i,

    // Other blocks' lines are among them.
    // verilator lint_off UNUSED
    input  wire [31:0] we_i,
    input  wire [31:0] re_i,
    // verilator lint_on UNUSED
    input  wire [3:0]  wstrb_i,
    input  wire [11:0] waddr_i,
    input  wire [31:0] wdata_i,
    input  wire [11:0] raddr_i,
    output wire [31:0] rdata_o,
    output wire        key_irq_o,
    output wire        jp1_irq_o,
    output wire        jp2_irq_o,

    output wire [9:0]  ledr_o,
    output wire [41:0] hex_no,     // HEX5 in 41:35 ... HEX0 in 6:0, segments g..a, 0 = lit
    input  wire [9:0]  sw_i,
    input  wire [3:0]  key_ni,     // 0 = pressed
    input  wire [31:0] jp1_i,
    output wire [31:0] jp1_o,
    output wire [31:0] jp1_oe_o,
    input  wire [31:0] jp2_i,
    output wire [31:0] jp2_o,
    output wire [31:0] jp2_oe_o,

    output wire        awake_o
);
    `include "regmap.vh"

    wire [31:0] ledr_rdata, hex_rdata, sw_rdata, key_rdata, jp1_rdata, jp2_rdata;
    // Bits that the port does not have stay 0.
    // verilator lint_off UNUSED
    wire [31:0] ledr;
    // verilator lint_on UNUSED

    assign rdata_o = ledr_rdata | hex_rdata | sw_rdata | key_rdata | jp1_rdata | jp2_rdata;
    assign ledr_o  = ledr[9:0];

    wire [5:0] awake;
    assign awake_o = awake != 6'd0;

    output_port #(.BITS(32'h0000_03ff)) ledr_port (
        .clk_i(clk_i), .rst_i(rst_i), .we_i(we_i[SEL_LEDR]), .wstrb_i(wstrb_i), .waddr_i(waddr_i),
        .wdata_i(wdata_i), .re_i(re_i[SEL_LEDR]), .raddr_i(raddr_i), .rdata_o(ledr_rdata),
        .pins_o(ledr), .awake_o(awake[0])
    );
    hex_port hex (
        .clk_i(clk_i), .rst_i(rst_i), .we_low_i(we_i[SEL_HEX3_0]), .we_high_i(we_i[SEL_HEX5_4]),
        .wstrb_i(wstrb_i), .waddr_i(waddr_i), .wdata_i(wdata_i), .re_low_i(re_i[SEL_HEX3_0]),
        .re_high_i(re_i[SEL_HEX5_4]), .raddr_i(raddr_i), .rdata_o(hex_rdata), .hex_no(hex_no),
        .awake_o(awake[1])
    );
    // Inputs only: these ports drive nothing.
    // verilator lint_off PINCONNECTEMPTY
    pio #(.WIDTH(10), .HAS_OUTPUT(0), .HAS_EDGE(0)) sw_port (
        .clk_i(clk_i), .rst_i(rst_i), .we_i(we_i[SEL_SW]), .wstrb_i(wstrb_i), .waddr_i(waddr_i),
        .wdata_i(wdata_i), .re_i(re_i[SEL_SW]), .raddr_i(raddr_i), .rdata_o(sw_rdata), .irq_o(),
        .pins_i(sw_i), .pins_o(), .oe_o(), .awake_o(awake[2])
    );
    pio #(.WIDTH(4), .HAS_OUTPUT(0)) key_port (
        .clk_i(clk_i), .rst_i(rst_i), .we_i(we_i[SEL_KEY]), .wstrb_i(wstrb_i), .waddr_i(waddr_i),
        .wdata_i(wdata_i), .re_i(re_i[SEL_KEY]), .raddr_i(raddr_i), .rdata_o(key_rdata),
        .irq_o(key_irq_o), .pins_i(~key_ni), .pins_o(), .oe_o(), .awake_o(awake[3])
    );
    // verilator lint_on PINCONNECTEMPTY
    pio jp1_port (
        .clk_i(clk_i), .rst_i(rst_i), .we_i(we_i[SEL_JP1]), .wstrb_i(wstrb_i), .waddr_i(waddr_i),
        .wdata_i(wdata_i), .re_i(re_i[SEL_JP1]), .raddr_i(raddr_i), .rdata_o(jp1_rdata),
        .irq_o(jp1_irq_o), .pins_i(jp1_i), .pins_o(jp1_o), .oe_o(jp1_oe_o),
        .awake_o(awake[4])
    );
    pio jp2_port (
        .clk_i(clk_i), .rst_i(rst_i), .we_i(we_i[SEL_JP2]), .wstrb_i(wstrb_i), .waddr_i(waddr_i),
        .wdata_i(wdata_i), .re_i(re_i[SEL_JP2]), .raddr_i(raddr_i), .rdata_o(jp2_rdata),
        .irq_o(jp2_irq_o), .pins_i(jp2_i), .pins_o(jp2_o), .oe_o(jp2_oe_o),
        .awake_o(awake[5])
    );
endmodule

`default_nettype wire
