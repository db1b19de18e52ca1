// altera_avalon_uart.v - Platform Designer's UART, without a FIFO
//
//   0 rxdata       the byte that has come
//   1 txdata       write: sends; what waits here goes as soon as the byte before has gone
//   2 status       PE 0, FE 1, BRK 2, ROE 3, TOE 4, TMT 5, TRDY 6, RRDY 7, E 8, DCTS 10, CTS 11,
//                  EOP 12; any write clears PE, FE, BRK, ROE, TOE, DCTS and EOP
//   3 control      the interrupts of these bits, where they are; TRBK 9 holds TXD low; RTS 11
//   4 divisor      of the clock, less 1, for a bit; where the rate is not fixed
//   5 endofpacket  a byte that sets EOP as it comes or goes; where useEopRegister
//
// PE, FE: the parity, the stop bit is wrong; BRK: RXD was low for longer than a frame; ROE: a byte
// has come over one that nobody had read; TOE: a byte was written over one that waited; E: any of
// these.  TMT: nothing is on the way; TRDY: txdata is free; RRDY: rxdata has a byte, until it is
// read.  DCTS: CTS has changed.
//
//   TXD  ~~|___|bit 0| ... |parity|~~~~~   start, DATA bits, parity, stop
//
// A bit counts in its middle.
//
// Source: Embedded Peripherals IP User Guide, UART Core.

`default_nettype none

module altera_avalon_uart #(
    parameter DIVISOR = 433,  // after a reset
    parameter FIXED   = 1,
    parameter DATA    = 8,    // 7, 8, 9
    parameter PARITY  = 0,    // 1: odd, 2: even
    parameter STOP    = 1,
    parameter EOP     = 0,    // the register endofpacket is there
    parameter CTS_RTS = 0
) (
    input  wire        clk,
    input  wire        reset_n,
    input  wire [2:0]  address,
    input  wire        chipselect,
    input  wire        read_n,
    input  wire        write_n,
    input  wire [15:0] writedata,
    output reg  [15:0] readdata,
    output wire        irq,
    input  wire        rxd,
    output wire        txd,
    input  wire        cts_n,
    output wire        rts_n
);
    localparam       PARITIES = PARITY == 0 ? 0 : 1;
    localparam [3:0] CHECKED  = DATA + PARITIES;        // the last bit before stop
    localparam [3:0] LAST     = DATA + PARITIES + STOP;
    localparam [8:0] BITS     = (9'd1 << DATA) - 9'd1;

    function parity_of(input [8:0] data);
        parity_of = ^data ^ (PARITY == 1);
    endfunction

    wire read     = chipselect && !read_n, write = chipselect && !write_n;
    wire writes   = write && address == 3'd1;          // txdata
    wire clears   = write && address == 3'd2;
    reg  [15:0] divisor_q, control_q, end_q;
    wire [15:0] divisor = FIXED != 0 ? DIVISOR[15:0] : divisor_q;

    // ---- Sent -------------------------------------------------------------
    reg         sends_q, waits_q, toe_q;
    reg  [8:0]  waiting_q;
    reg  [15:0] tx_clock_q;
    reg  [3:0]  tx_bit_q;
    reg  [10:0] left_q;          // start, data, parity, then ones; bit 0 is on the wire
    wire        starts = waits_q && !sends_q;
    wire [10:0] parity = PARITY != 0 && !parity_of(waiting_q) ? 11'd2 << DATA : 11'd0;

    assign txd   = (!sends_q || left_q[0]) && !control_q[9];
    assign rts_n = !control_q[11];

    always @(posedge clk) begin
        if (writes) begin
            waiting_q <= writedata[8:0] & BITS;
            toe_q     <= toe_q || (waits_q && !starts);
        end
        waits_q <= writes || (waits_q && !starts);
        if (starts) begin
            sends_q    <= 1'b1;
            left_q     <= ({1'b1, waiting_q, 1'b0} | (11'h7FE << DATA)) & ~parity;
            tx_clock_q <= 16'd0;
            tx_bit_q   <= 4'd0;
        end
        if (sends_q) begin
            tx_clock_q <= tx_clock_q == divisor ? 16'd0 : tx_clock_q + 16'd1;
            if (tx_clock_q == divisor) begin
                left_q   <= {1'b1, left_q[10:1]};
                tx_bit_q <= tx_bit_q + 4'd1;
                if (tx_bit_q == LAST) sends_q <= 1'b0;
            end
        end
        if (clears) toe_q <= 1'b0;
        if (!reset_n) {sends_q, waits_q, toe_q} <= 3'b000;
    end

    // ---- Received ---------------------------------------------------------
    reg  [1:0]  rxd_q;
    reg         receives_q, broken_q;   // broken_q: RXD has been low since the frame began
    reg  [15:0] rx_clock_q;
    reg  [3:0]  rx_bit_q;
    reg  [9:0]  got_q;                  // the latest on top: data, and after them parity
    reg  [8:0]  rxdata_q;
    reg         pe_q, fe_q, brk_q, roe_q, rrdy_q;
    wire [9:0]  frame = got_q >> (10 - CHECKED);
    wire [8:0]  come  = frame[8:0] & BITS;
    wire        middle = receives_q && rx_clock_q == {1'b0, divisor[15:1]};
    wire        comes  = middle && rx_bit_q == CHECKED + 4'd1;

    always @(posedge clk) begin
        rxd_q <= {rxd_q[0], rxd};
        if (!receives_q && !rxd_q[1] && !broken_q) begin
            receives_q <= 1'b1;
            broken_q   <= 1'b1;
            rx_clock_q <= 16'd0;
            rx_bit_q   <= 4'd0;
        end
        if (rxd_q[1]) broken_q <= 1'b0;
        if (receives_q) begin
            rx_clock_q <= rx_clock_q == divisor ? 16'd0 : rx_clock_q + 16'd1;
            if (rx_clock_q == divisor) rx_bit_q <= rx_bit_q + 4'd1;
            if (middle) got_q <= {rxd_q[1], got_q[9:1]};
            // A start bit that has gone was none.
            if (comes || (middle && rx_bit_q == 4'd0 && rxd_q[1])) receives_q <= 1'b0;
        end
        if (read && address == 3'd0) rrdy_q <= 1'b0;
        if (clears) {pe_q, fe_q, brk_q, roe_q} <= 4'b0000;
        if (comes) begin
            rxdata_q <= come;
            rrdy_q   <= 1'b1;
            if (rrdy_q && !(read && address == 3'd0)) roe_q <= 1'b1;
            if (PARITY != 0 && frame[DATA] != parity_of(come)) pe_q <= 1'b1;
            if (!rxd_q[1]) fe_q <= 1'b1;
            if (broken_q && !rxd_q[1]) brk_q <= 1'b1;
        end
        if (!reset_n) begin
            rxd_q <= 2'b11;
            {receives_q, broken_q, pe_q, fe_q, brk_q, roe_q, rrdy_q} <= 7'd0;
        end
    end

    // ---- Registers --------------------------------------------------------
    reg  [1:0]  cts_q;
    reg         cts_before_q, dcts_q, eop_q;
    wire        cts    = CTS_RTS != 0 && !cts_q[1];
    wire        errors = pe_q || fe_q || brk_q || roe_q || toe_q;
    wire [12:0] status = {eop_q, cts, dcts_q, 1'b0, errors, rrdy_q, !waits_q,
                          !sends_q && !waits_q, toe_q, roe_q, brk_q, fe_q, pe_q};
    // Of the interrupts, TRBK and RTS are none, and CTS has none.
    assign irq = (status & control_q[12:0] & 13'h15FF) != 13'd0;

    always @(posedge clk) begin
        cts_q        <= {cts_q[0], cts_n};
        cts_before_q <= cts;
        if (cts != cts_before_q) dcts_q <= 1'b1;
        if (EOP != 0 && ((comes && come == end_q[8:0])
                         || (writes && (writedata[8:0] & BITS) == end_q[8:0]))) eop_q <= 1'b1;
        if (clears) {dcts_q, eop_q} <= 2'b00;
        if (write && address == 3'd3) control_q <= writedata;
        if (write && address == 3'd4) divisor_q <= writedata;
        if (write && address == 3'd5) end_q <= writedata & {7'd0, BITS};
        case (address)
            3'd0:    readdata <= {7'd0, rxdata_q};
            3'd1:    readdata <= {7'd0, waiting_q};
            3'd2:    readdata <= {3'd0, status};
            3'd3:    readdata <= control_q;
            3'd4:    readdata <= FIXED != 0 ? 16'd0 : divisor_q;
            default: readdata <= EOP != 0 ? end_q : 16'd0;
        endcase
        if (!reset_n) begin
            cts_q        <= 2'b11;
            cts_before_q <= 1'b0;
            divisor_q    <= DIVISOR[15:0];
            {control_q, end_q} <= 32'd0;
            {dcts_q, eop_q}    <= 2'b00;
        end
    end
endmodule

`default_nettype wire
