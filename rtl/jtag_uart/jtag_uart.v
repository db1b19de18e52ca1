// jtag_uart.v - JTAG UART in the register layout of the DE1-SoC Computer, 64 bytes deep each way
//
//   +0 DATA      read: RAVAIL[31:16] left after this one, RVALID bit 15, bits 14:8 as in CONTROL,
//                the oldest byte, which goes away; while none waits, the byte that was read last;
//                write: a byte to the host, dropped if WSPACE is 0
//   +4 CONTROL   RE bit 0, WE bit 1: enable RI and WI, which interrupt; AC bit 10: the host has
//                been active, write 1 clears; WAITS bit 12: bytes wait; ROOM bit 13: there is room
//                for one to the host; LOST bit 14: the last byte to it was dropped; RVALID bit 15
//                of the last read of DATA; WSPACE[31:16]: room for bytes to the host
//                RI bit 8: there is room for 8 bytes from the host or fewer, or the host has paused
//                after bytes and DATA has not been read since
//                WI bit 9: 8 bytes or fewer wait for the host
//
// The host's side has the timing and meaning of the ports of Quartus' alt_jtag_atlantic:
//
//   take_i  (r_ena)    the host takes a byte in this clock, if there is one
//   sent_o  (r_val)    one clock later: here it is, in sent_data_o (r_dat)
//   room_o  (t_dav)    the host may send
//   typed_i (t_ena)    a byte from the host, in typed_data_i (t_dat)
//   idle_i  (t_pause)  the host has looked and has nothing to send
//
// Source: Embedded Peripherals IP User Guide, JTAG UART Core, with its thresholds of 8; the Verilog
// that it generates for the DE1-SoC Computer, for the bits that the guide reserves: WAITS, ROOM,
// LOST, and those of DATA.

`default_nettype none

module jtag_uart (
    input  wire        clk_i,
    input  wire        rst_i,

    input  wire        we_i,
    // Only the register's offset in the block is used; few bits can be written.
    // verilator lint_off UNUSED
    input  wire [3:0]  wstrb_i,
    input  wire [11:0] waddr_i,
    input  wire [11:0] raddr_i,
    input  wire [31:0] wdata_i,
    // verilator lint_on UNUSED
    input  wire        re_i,
    output reg  [31:0] rdata_o,
    output wire        irq_o,

    input  wire        take_i,
    output reg         sent_o,
    output reg  [7:0]  sent_data_o,
    output reg         room_o,
    input  wire        typed_i,
    input  wire [7:0]  typed_data_i,
    input  wire        idle_i,

    output wire        awake_o
);
    `include "regmap.vh"

    localparam [6:0] DEPTH = 7'd64, THRESHOLD = 7'd8;

    wire we_data    = we_i && wstrb_i[0] && waddr_i[2] == JTAG_UART0_DATA[2];
    wire we_control = we_i && waddr_i[2] == JTAG_UART0_CONTROL[2];
    wire re_data    = re_i && raddr_i[2] == JTAG_UART0_DATA[2];

    // ---- Bytes to the host and from it ------------------------------------
    wire [6:0] write_count, read_count;
    wire [7:0] write_head, read_head;

    // A write to a full FIFO is dropped by the FIFO; programs ask WSPACE before.
    small_fifo write_fifo (
        .clk_i(clk_i), .rst_i(rst_i), .push_i(we_data), .wdata_i(wdata_i[7:0]),
        .pop_i(take_i), .rdata_o(write_head), .count_o(write_count)
    );
    small_fifo read_fifo (
        .clk_i(clk_i), .rst_i(rst_i), .push_i(typed_i), .wdata_i(typed_data_i),
        .pop_i(re_data), .rdata_o(read_head), .count_o(read_count)
    );

    // ---- Registers --------------------------------------------------------
    reg       re_q, we_q, ac_q, paused_q, valid_q, lost_q;
    reg       take_q;            // take_i was high in the clock before
    reg [7:0] last_q;            // read

    wire       some  = read_count != 7'd0;
    wire [6:0] left  = read_count - {6'd0, some};
    wire       full  = write_count == DEPTH;

    wire takes = take_i && write_count != 7'd0;
    wire room  = read_count != DEPTH;
    wire ri    = re_q && (paused_q || DEPTH - read_count <= THRESHOLD);
    wire wi    = we_q && write_count <= THRESHOLD;

    assign irq_o   = ri || wi;
    assign awake_o = rdata_o != 32'd0 || (take_q && write_count != 7'd0) || sent_o
                     || room != room_o;

    always @(posedge clk_i) begin
        rdata_o <= 32'd0;
        if (re_i) begin   // bits 14 to 8 of DATA are those of CONTROL
            rdata_o[JTAG_UART0_CONTROL_RI_LSB]   <= ri;
            rdata_o[JTAG_UART0_CONTROL_WI_LSB]   <= wi;
            rdata_o[JTAG_UART0_CONTROL_AC_LSB]   <= ac_q;
            rdata_o[JTAG_UART0_CONTROL_ROOM_LSB] <= !full;
            rdata_o[JTAG_UART0_CONTROL_LOST_LSB] <= lost_q;
        end
        if (re_data) begin
            rdata_o[JTAG_UART0_DATA_DATA_LSB +: 8]   <= some ? read_head : last_q;
            rdata_o[JTAG_UART0_CONTROL_WAITS_LSB]    <= left != 7'd0;
            rdata_o[JTAG_UART0_DATA_RVALID_LSB]      <= some;
            rdata_o[JTAG_UART0_DATA_RAVAIL_LSB +: 7] <= left;
            valid_q <= some;
            if (some) last_q <= read_head;
        end else if (re_i) begin
            rdata_o[JTAG_UART0_CONTROL_RE_LSB]          <= re_q;
            rdata_o[JTAG_UART0_CONTROL_WE_LSB]          <= we_q;
            rdata_o[JTAG_UART0_CONTROL_WAITS_LSB]       <= some;
            rdata_o[JTAG_UART0_CONTROL_RVALID_LSB]      <= valid_q;
            rdata_o[JTAG_UART0_CONTROL_WSPACE_LSB +: 7] <= DEPTH - write_count;
        end
        if (we_data) lost_q <= full;

        take_q <= take_i;
        room_o <= room && !rst_i;
        sent_o <= takes && !rst_i;
        if (takes) sent_data_o <= write_head;

        if (idle_i && read_count != 7'd0) paused_q <= 1'b1;
        else if (re_data) paused_q <= 1'b0;
        if (typed_i || idle_i) ac_q <= 1'b1;
        else if (we_control && wstrb_i[1] && wdata_i[JTAG_UART0_CONTROL_AC_LSB]) ac_q <= 1'b0;
        if (we_control && wstrb_i[0]) begin
            re_q <= wdata_i[JTAG_UART0_CONTROL_RE_LSB];
            we_q <= wdata_i[JTAG_UART0_CONTROL_WE_LSB];
        end
        if (rst_i) {re_q, we_q, ac_q, paused_q, valid_q, lost_q, last_q} <= 14'd0;
    end
endmodule

`default_nettype wire
