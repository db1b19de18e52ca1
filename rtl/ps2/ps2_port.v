// ps2_port.v - PS/2 port in the register layout of the DE1-SoC Computer, 256 bytes deep
//
//   +0 DATA      read: RAVAIL[31:16] bytes with this one, RVALID bit 15, the oldest byte, which
//                goes away; while none waits RVALID is 0, and the byte that was read last stands
//                there once more.  A read that leaves the lowest byte out takes nothing away.
//                write: a byte to the device; the bus waits until it has been sent or has failed
//   +4 CONTROL   RE bit 0: interrupt while RI; RI bit 8: RE, and a byte waits; CE bit 10: a byte
//                could not be sent, which a write of anything to this byte clears
//
// A byte that arrives when 256 wait is lost.  A byte takes 1 ms or so to be sent, and 15 ms where
// no device is.
//
// Source: University Program, PS/2 Core for Altera DE-Series Boards, and its published Verilog as
// the DE1-SoC Computer has it.

`default_nettype none

module ps2_port (
    input  wire        clk_i,
    input  wire        rst_i,
    input  wire        tick_i,         // every 32 clocks

    input  wire        we_i,
    // Only the register's offset in the block is used; registers have few bits.
    // verilator lint_off UNUSED
    input  wire [3:0]  wstrb_i,
    input  wire [11:0] waddr_i,
    input  wire [11:0] raddr_i,
    input  wire [31:0] wdata_i,
    // verilator lint_on UNUSED
    input  wire        re_i,
    input  wire        rlow_i,         // valid with re_i: the lowest byte is read, too
    output reg  [31:0] rdata_o,
    output wire        wait_o,         // a write has not ended yet
    output wire        irq_o,

    input  wire        ps2_clk_i,      // asynchronous
    input  wire        ps2_dat_i,
    output wire        ps2_clk_low_o,  // 1 = pull low
    output wire        ps2_dat_low_o,

    output wire        awake_o,
    output wire        wants_tick_o    // the next tick changes something
);
    `include "regmap.vh"

    wire re_data = re_i && raddr_i[2] == PS2_0_DATA[2];
    wire we_data = we_i && wstrb_i[0] && waddr_i[2] == PS2_0_DATA[2];

    // ---- Bytes ------------------------------------------------------------
    wire       busy, failed, come, empty;
    wire [7:0] come_data, head;
    wire [8:0] count;

    ps2_link link (
        .clk_i(clk_i), .rst_i(rst_i), .tick_i(tick_i),
        .send_i(we_data && !busy),
        .send_data_i(wdata_i[7:0]),
        .busy_o(busy), .failed_o(failed), .come_o(come), .come_data_o(come_data),
        .ps2_clk_i(ps2_clk_i), .ps2_dat_i(ps2_dat_i),
        .ps2_clk_low_o(ps2_clk_low_o), .ps2_dat_low_o(ps2_dat_low_o),
        .wants_tick_o(wants_tick_o)
    );

    // verilator lint_off PINCONNECTEMPTY
    fifo #(.WIDTH(8), .DEPTH_LOG2(8)) fifo (
        .clk_i(clk_i), .rst_i(rst_i), .clear_i(1'b0), .push_i(come && tick_i),
        .wdata_i(come_data), .pop_i(re_data && rlow_i), .rdata_o(head), .count_o(count), .full_o(),
        .empty_o(empty), .awake_o()
    );
    // verilator lint_on PINCONNECTEMPTY

    // ---- Registers --------------------------------------------------------
    reg re_q, ce_q;

    wire ri = re_q && !empty;

    assign irq_o   = ri;
    assign wait_o  = busy || we_data;
    assign awake_o = rdata_o != 32'd0;

    always @(posedge clk_i) begin
        rdata_o <= 32'd0;
        if (re_data) begin
            rdata_o[PS2_0_DATA_DATA_LSB +: 8]   <= head;
            rdata_o[PS2_0_DATA_RVALID_LSB]      <= !empty;
            rdata_o[PS2_0_DATA_RAVAIL_LSB +: 9] <= count;
        end else if (re_i) begin
            rdata_o[PS2_0_CONTROL_RE_LSB] <= re_q;
            rdata_o[PS2_0_CONTROL_RI_LSB] <= ri;
            rdata_o[PS2_0_CONTROL_CE_LSB] <= ce_q;
        end

        if (we_i && waddr_i[2] == PS2_0_CONTROL[2]) begin
            if (wstrb_i[0]) re_q <= wdata_i[PS2_0_CONTROL_RE_LSB];
            if (wstrb_i[1]) ce_q <= 1'b0;
        end
        if (failed && tick_i) ce_q <= 1'b1;
        if (rst_i) {re_q, ce_q} <= 2'd0;
    end
endmodule

`default_nettype wire
