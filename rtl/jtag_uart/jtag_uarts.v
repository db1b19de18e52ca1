// jtag_uarts.v - the two JTAG UARTs of the DE1-SoC Computer; bit or byte n belongs to number n
//
// Registers and the host's side: jtag_uart.v.

`default_nettype none

module jtag_uarts (
    input  wire        clk_i,
    input  wire        rst_i,

    input  wire [1:0]  we_i,
    input  wire [3:0]  wstrb_i,
    input  wire [11:0] waddr_i,
    input  wire [31:0] wdata_i,
    input  wire [1:0]  re_i,
    input  wire [11:0] raddr_i,
    output wire [31:0] rdata_o,
    output wire [1:0]  irq_o,

    input  wire [1:0]  take_i,
    output wire [1:0]  sent_o,
    output wire [15:0] sent_data_o,
    output wire [1:0]  room_o,
    input  wire [1:0]  typed_i,
    input  wire [15:0] typed_data_i,
    input  wire [1:0]  idle_i,

    output wire        awake_o
);
    wire [31:0] rdata0, rdata1;

    wire        awake0, awake1;

    assign rdata_o = rdata0 | rdata1;
    assign awake_o = awake0 || awake1;

    jtag_uart jtag_uart0 (
        .clk_i(clk_i), .rst_i(rst_i), .we_i(we_i[0]), .wstrb_i(wstrb_i), .waddr_i(waddr_i),
        .wdata_i(wdata_i), .re_i(re_i[0]), .raddr_i(raddr_i), .rdata_o(rdata0),
        .irq_o(irq_o[0]), .take_i(take_i[0]), .sent_o(sent_o[0]),
        .sent_data_o(sent_data_o[7:0]), .room_o(room_o[0]), .typed_i(typed_i[0]),
        .typed_data_i(typed_data_i[7:0]), .idle_i(idle_i[0]), .awake_o(awake0)
    );
    jtag_uart jtag_uart1 (
        .clk_i(clk_i), .rst_i(rst_i), .we_i(we_i[1]), .wstrb_i(wstrb_i), .waddr_i(waddr_i),
        .wdata_i(wdata_i), .re_i(re_i[1]), .raddr_i(raddr_i), .rdata_o(rdata1),
        .irq_o(irq_o[1]), .take_i(take_i[1]), .sent_o(sent_o[1]),
        .sent_data_o(sent_data_o[15:8]), .room_o(room_o[1]), .typed_i(typed_i[1]),
        .typed_data_i(typed_data_i[15:8]), .idle_i(idle_i[1]), .awake_o(awake1)
    );
endmodule

`default_nettype wire
