// de1sim_up_serial.v - the University Program's serial ports: RS-232 and IrDA
//
//   +0 data      read: RAVAIL[23:16] bytes with this one, RVALID bit 15, PE bit 9: its parity is
//                wrong, the oldest byte [8:0], which it removes; while none waits, the byte that
//                was read last.  A read that leaves the lowest byte out removes nothing.
//                write: sends the byte; it is lost when 128 wait
//   +4 control   RE bit 0: interrupt while RI; WE bit 1: while WI; RI bit 8: RE, and 96 bytes or
//                more to read; WI bit 9: WE, and room for 96 or more; WSPACE[23:16] the room
//
//   level   ~~|___|=bit 0==|=bit 1==| ... |parity|~~~~    a frame: start, DATA bits, stop
//   light   ~~|_|~|_|~~~~~ a pulse of PULSE clocks for each 0; received low, sent high
//
// A frame begins with the first low level; each bit is the level SAMPLE clocks after the bit's
// begin.  The stop bit is not checked: one long low level is received as zeros.
//
// Source: Intel FPGA University Program, RS232 UART and IrDA UART for DE-Series Boards.

`default_nettype none

module de1sim_up_serial #(
    parameter BIT    = 868,  // clocks
    parameter SAMPLE = 434,
    parameter PULSE  = 0,    // 0: levels
    parameter DATA   = 8,    // 7, 8, 9
    parameter PARITY = 0,    // 1: odd, 2: even
    parameter STOP   = 1     // bits that are sent
) (
    input  wire        clk,
    input  wire        reset,
    input  wire        address,
    input  wire        chipselect,
    // verilator lint_off UNUSED
    input  wire [3:0]  byteenable,
    input  wire        read,
    input  wire        write,
    input  wire [31:0] writedata,
    // verilator lint_on UNUSED
    output reg  [31:0] readdata,
    output reg         irq,
    input  wire        rxd,
    output reg         txd
);
    localparam        PARITIES = PARITY == 0 ? 0 : 1;
    localparam [3:0]  CHECKED  = DATA + PARITIES;        // the number of the last bit before stop
    localparam [3:0]  LAST     = DATA + PARITIES + STOP;
    localparam [19:0] SPAN = BIT - 1, AT = SAMPLE;
    // Of the stop bit: early, so as not to fall behind.
    localparam [19:0] END = PULSE == 0 ? SAMPLE : BIT - 1 - BIT / 50;

    wire low  = chipselect && byteenable[0];
    wire push = low && write && !address;
    wire pop  = low && read && !address;

    function parity_of(input [8:0] data);
        parity_of = ^data ^ (PARITY == 1);
    endfunction

    // ---- Received ---------------------------------------------------------
    reg  [1:0]  rxd_q;
    reg         receives_q, come_q;
    reg  [19:0] rx_clock_q;
    reg  [3:0]  rx_bit_q;
    reg  [9:0]  got_q;        // the latest on top: data, and after them parity
    wire [9:0]  frame  = got_q >> (10 - CHECKED);
    wire [8:0]  come   = frame[8:0] & ~(9'h1FF << DATA);
    wire        wrong  = PARITY != 0 && frame[DATA] != parity_of(come);
    wire [9:0]  oldest;
    wire [7:0]  count;

    always @(posedge clk) begin
        rxd_q  <= {rxd_q[0], rxd};
        come_q <= 1'b0;
        if (!receives_q && !rxd_q[1]) begin
            receives_q <= 1'b1;
            rx_clock_q <= 20'd0;
            rx_bit_q   <= 4'd0;
        end
        if (receives_q) begin
            rx_clock_q <= rx_clock_q == SPAN ? 20'd0 : rx_clock_q + 20'd1;
            if (rx_clock_q == SPAN) rx_bit_q <= rx_bit_q + 4'd1;
            if (rx_clock_q == AT && rx_bit_q <= CHECKED) got_q <= {rxd_q[1], got_q[9:1]};
            if (rx_clock_q == END && rx_bit_q == CHECKED + 4'd1) begin
                receives_q <= 1'b0;
                come_q     <= 1'b1;
            end
        end
        if (reset) begin
            rxd_q      <= 2'b11;
            receives_q <= 1'b0;
            come_q     <= 1'b0;
        end
    end

    de1sim_up_fifo #(.WIDTH(10)) in (
        .clk_i(clk), .rst_i(reset), .push_i(come_q), .wdata_i({wrong, come}), .pop_i(pop),
        .rdata_o(oldest), .count_o(count)
    );

    // ---- Sent -------------------------------------------------------------
    reg         sends_q;
    reg  [19:0] tx_clock_q;
    reg  [3:0]  tx_bit_q;
    reg  [10:0] left_q;       // start, data, parity, then ones; bit 0 is on the wire
    wire [8:0]  next;
    wire [7:0]  waiting;
    wire        starts = !sends_q && waiting != 8'd0;
    wire [10:0] begun = {1'b1, next, 1'b0} | (11'h7FE << DATA);
    wire [10:0] clear = PARITY != 0 && !parity_of(next & ~(9'h1FF << DATA)) ? 11'd2 << DATA : 11'd0;

    de1sim_up_fifo #(.WIDTH(9)) out (
        .clk_i(clk), .rst_i(reset), .push_i(push), .wdata_i(writedata[8:0]), .pop_i(starts),
        .rdata_o(next), .count_o(waiting)
    );

    always @(posedge clk) begin
        txd <= PULSE == 0 ? !sends_q || left_q[0]
                          : sends_q && !left_q[0] && tx_clock_q < PULSE;
        if (starts) begin
            sends_q    <= 1'b1;
            left_q     <= begun & ~clear;
            tx_clock_q <= 20'd0;
            tx_bit_q   <= 4'd0;
        end
        if (sends_q) begin
            tx_clock_q <= tx_clock_q == SPAN ? 20'd0 : tx_clock_q + 20'd1;
            if (tx_clock_q == SPAN) begin
                left_q   <= {1'b1, left_q[10:1]};
                tx_bit_q <= tx_bit_q + 4'd1;
                if (tx_bit_q == LAST) sends_q <= 1'b0;
            end
        end
        if (reset) begin
            sends_q <= 1'b0;
            txd     <= PULSE == 0;
        end
    end

    // ---- Registers --------------------------------------------------------
    reg        re_q, we_q;
    wire [7:0] space = 8'd128 - waiting;
    wire       ri = re_q && count >= 8'd96, wi = we_q && space >= 8'd96;

    always @(posedge clk) begin
        irq      <= ri || wi;
        readdata <= address ? {8'd0, space, 6'd0, wi, ri, 6'd0, we_q, re_q}
                            : {8'd0, count, count != 8'd0, 5'd0, oldest};
        if (low && write && address) {we_q, re_q} <= writedata[1:0];
        if (reset) {irq, we_q, re_q} <= 3'b000;
    end
endmodule

`default_nettype wire
