// irda.v - the DE1-SoC Computer's IrDA port: bytes by infrared light
//
//   +0 DATA      read: RAVAIL[23:16], RVALID bit 15, the oldest byte [7:0], which it removes; while
//                none waits, the byte that was read last.  A read without the lowest byte removes
//                nothing
//                write: sends the byte [7:0]; dropped when 128 wait
//   +4 CONTROL   WSPACE[23:16], WI bit 9, RI bit 8, WE bit 1, RE bit 0
//
// RI: with RE, 96 bytes or more to read; WI: with WE, room for 96 or more.  Each interrupts.
//
// Source: the IrDA UART core of Altera's University Program as the DE1-SoC Computer has it, at
// 115,200 baud.  The board's receiver passes light of 38 kHz only and is slow to release its
// output.  So a remote control is received as runs of zero bytes: one byte per 87 us of light.
//
// Not handled: parity (PE, bit 9 of DATA, is 0: the computer has none).

`default_nettype none

module irda (
    input  wire        clk_i,
    input  wire        rst_i,

    input  wire        we_i,
    // Only the register's offset in the block is used, and the low byte lane.
    // verilator lint_off UNUSED
    input  wire [3:0]  wstrb_i,
    input  wire [11:0] waddr_i,
    input  wire [31:0] wdata_i,
    input  wire [11:0] raddr_i,
    // verilator lint_on UNUSED
    input  wire        re_i,
    input  wire        rlow_i,    // valid with re_i: the lowest byte is read, too
    output reg  [31:0] rdata_o,
    output reg         irq_o,

    input  wire        rxd_i,     // asynchronous, high while it is dark
    output wire        txd_o,     // 1 = light

    output wire        awake_o
);
    `include "regmap.vh"

    localparam [7:0] DEPTH     = IRDA_CONTROL_RESET[IRDA_CONTROL_WSPACE_LSB +: 8];
    localparam [7:0] THRESHOLD = 8'd96;

    wire we_low     = we_i && wstrb_i[0];
    wire we_data    = we_low && waddr_i[2] == IRDA_DATA[2];
    wire we_control = we_low && waddr_i[2] == IRDA_CONTROL[2];
    wire re_data    = re_i && raddr_i[2] == IRDA_DATA[2];

    // ---- Bytes ------------------------------------------------------------
    wire       received, take, none_in, none_out, rx_awake, tx_awake;
    wire [7:0] byte_in, read_byte, byte_out, in_count, out_count;

    irda_rx rx (
        .clk_i(clk_i), .rst_i(rst_i), .rxd_i(rxd_i), .valid_o(received), .data_o(byte_in),
        .awake_o(rx_awake)
    );
    // A full FIFO drops by itself, and nothing clears one.
    // verilator lint_off PINCONNECTEMPTY
    fifo #(.WIDTH(8)) in_fifo (
        .clk_i(clk_i), .rst_i(rst_i), .clear_i(1'b0), .push_i(received), .wdata_i(byte_in),
        .pop_i(re_data && rlow_i), .rdata_o(read_byte), .count_o(in_count), .full_o(),
        .empty_o(none_in), .awake_o()
    );
    fifo #(.WIDTH(8)) out_fifo (
        .clk_i(clk_i), .rst_i(rst_i), .clear_i(1'b0), .push_i(we_data), .wdata_i(wdata_i[7:0]),
        .pop_i(take), .rdata_o(byte_out), .count_o(out_count), .full_o(), .empty_o(none_out),
        .awake_o()
    );
    // verilator lint_on PINCONNECTEMPTY
    irda_tx tx (
        .clk_i(clk_i), .rst_i(rst_i), .waits_i(!none_out), .data_i(byte_out), .take_o(take),
        .txd_o(txd_o), .awake_o(tx_awake)
    );

    // ---- Interrupt and registers -------------------------------------------
    reg        re_q, we_q;
    wire [7:0] space = DEPTH - out_count;
    wire       ri    = re_q && in_count >= THRESHOLD;
    wire       wi    = we_q && space >= THRESHOLD;

    assign awake_o = rdata_o != 32'd0 || irq_o != (ri || wi) || rx_awake || tx_awake;

    always @(posedge clk_i) begin
        irq_o   <= ri || wi;
        rdata_o <= 32'd0;
        if (re_data) begin
            rdata_o[IRDA_DATA_DATA_LSB +: IRDA_DATA_DATA_W]     <= read_byte;
            rdata_o[IRDA_DATA_RVALID_LSB]                       <= !none_in;
            rdata_o[IRDA_DATA_RAVAIL_LSB +: IRDA_DATA_RAVAIL_W] <= in_count;
        end else if (re_i) begin
            rdata_o[IRDA_CONTROL_RE_LSB]                              <= re_q;
            rdata_o[IRDA_CONTROL_WE_LSB]                              <= we_q;
            rdata_o[IRDA_CONTROL_RI_LSB]                              <= ri;
            rdata_o[IRDA_CONTROL_WI_LSB]                              <= wi;
            rdata_o[IRDA_CONTROL_WSPACE_LSB +: IRDA_CONTROL_WSPACE_W] <= space;
        end
        if (we_control) begin
            re_q <= wdata_i[IRDA_CONTROL_RE_LSB];
            we_q <= wdata_i[IRDA_CONTROL_WE_LSB];
        end
        if (rst_i) begin
            irq_o        <= 1'b0;
            {we_q, re_q} <= 2'b00;
        end
    end
endmodule

`default_nettype wire
