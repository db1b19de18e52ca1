// altera_avalon_fifo.v - Platform Designer's FIFO between two slaves, two streams, or one of each
//
//   avalonmm_write_slave or                    avalonmm_read_slave or
//   avalonst_sink         --> 2^LOG2 words --> avalonst_source
//   wrclk_control_slave                        rdclk_control_slave
//
// A write waits while the FIFO is full, a read while it is empty; where nobody looks at waitrequest
// the first is lost and the second has the word before.  With two clocks (DUAL) it is full with
// three words fewer, and each side sees the other's some clocks later.  Between a slave and a
// stream the symbols (of SYMBOL bits) change their order: a stream's first is its highest, a
// slave's its lowest.  Streams have a ready latency of 1.
//
// Between a slave and a stream the slave's second register is what goes with the data:
//
//   bit 0 startofpacket  1 endofpacket  2 to 6 empty  8 to 15 channel  16 to 23 error
//
// It is written before its data, which take it along and clear the first two; a read has that of
// the data that were read last.
//
// Registers: de1sim_avalon_fifo_csr.v.
//
// Source: Embedded Peripherals IP User Guide, Avalon FIFO Memory Core, and the Verilog that it
// generates.

`default_nettype none

module altera_avalon_fifo #(
    parameter WIDTH  = 32,
    parameter LOG2   = 4,
    parameter DUAL   = 0,
    parameter RESETS = 2,    // with DUAL; 1 = wrreset_n resets both sides
    parameter SINK   = 0,    // 1 = a stream comes in
    parameter SOURCE = 0,    // 1 = a stream goes out
    parameter SYMBOL = 8,
    parameter WAITS  = 1,    // 0 = without backpressure: streams are always ready
    parameter EAB    = 1,    // 0 = of registers
    parameter EMPTY  = 1,    // bits
    parameter CHANNEL = 1,
    parameter ERROR  = 1
) (
    input  wire             wrclock,
    input  wire             wrreset_n,
    // verilator lint_off UNUSED
    input  wire             rdclock,       // with DUAL
    input  wire             rdreset_n,
    // verilator lint_on UNUSED

    input  wire             avalonmm_write_slave_address,
    input  wire             avalonmm_write_slave_write,
    input  wire [WIDTH-1:0] avalonmm_write_slave_writedata,
    output wire             avalonmm_write_slave_waitrequest,
    input  wire             avalonst_sink_valid,
    input  wire [WIDTH-1:0] avalonst_sink_data,
    input  wire             avalonst_sink_startofpacket,
    input  wire             avalonst_sink_endofpacket,
    input  wire [EMPTY-1:0] avalonst_sink_empty,
    input  wire [CHANNEL-1:0] avalonst_sink_channel,
    input  wire [ERROR-1:0] avalonst_sink_error,
    output wire             avalonst_sink_ready,

    input  wire             avalonmm_read_slave_address,
    input  wire             avalonmm_read_slave_read,
    output wire [WIDTH-1:0] avalonmm_read_slave_readdata,
    output wire             avalonmm_read_slave_waitrequest,
    output reg              avalonst_source_valid,
    output wire [WIDTH-1:0] avalonst_source_data,
    output wire             avalonst_source_startofpacket,
    output wire             avalonst_source_endofpacket,
    output wire [EMPTY-1:0] avalonst_source_empty,
    output wire [CHANNEL-1:0] avalonst_source_channel,
    output wire [ERROR-1:0] avalonst_source_error,
    input  wire             avalonst_source_ready,

    input  wire [2:0]       wrclk_control_slave_address,
    input  wire             wrclk_control_slave_read,
    input  wire             wrclk_control_slave_write,
    input  wire [31:0]      wrclk_control_slave_writedata,
    output wire [31:0]      wrclk_control_slave_readdata,
    output wire             wrclk_control_slave_irq,
    // verilator lint_off UNUSED
    input  wire [2:0]       rdclk_control_slave_address,
    input  wire             rdclk_control_slave_read,
    input  wire             rdclk_control_slave_write,
    input  wire [31:0]      rdclk_control_slave_writedata,
    // verilator lint_on UNUSED
    output wire [31:0]      rdclk_control_slave_readdata,
    output wire             rdclk_control_slave_irq
);
    localparam DEPTH = 1 << LOG2, HIGHEST = DUAL != 0 ? DEPTH - 4 : DEPTH - 1;
    localparam INFO  = 2 + EMPTY + CHANNEL + ERROR, ALL = INFO + WIDTH;

    wire [WIDTH-1:0] q, turned;
    wire             write_full, write_empty, read_empty;
    wire [LOG2:0]    write_level;
    wire             reads_seen;   // by the side of the writes
    reg              was_ready_q;  // the stream that comes in
    wire             ready = !write_full && (write_level < HIGHEST[LOG2:0] || !avalonst_sink_valid);
    wire             asks_write = SINK != 0 ? avalonst_sink_valid && (was_ready_q || WAITS == 0)
                                  : avalonmm_write_slave_write && !avalonmm_write_slave_address;
    wire             asks_read  = SOURCE != 0
                                  ? (avalonst_source_ready || WAITS == 0) && !read_empty
                                  : avalonmm_read_slave_read && !avalonmm_read_slave_address;
    wire             writes = asks_write && !write_full;
    wire             reads  = asks_read && !read_empty;

    assign avalonmm_write_slave_waitrequest = write_full;
    assign avalonst_sink_ready              = ready;
    assign avalonmm_read_slave_waitrequest  = read_empty && !avalonmm_read_slave_address;
    assign avalonst_source_data             = turned;

    // ---- What goes with the data ----
    // A slave's word has more bits than the signals.
    // verilator lint_off UNUSED
    reg  [INFO-1:0] info_q;     // to go with the next word
    wire [INFO-1:0] info_read;  // of the last word
    wire [31:0]     wide = {{32-ERROR{1'b0}}, avalonst_source_error} << 16
                           | {{32-CHANNEL{1'b0}}, avalonst_source_channel} << 8
                           | {{32-EMPTY{1'b0}}, avalonst_source_empty} << 2
                           | {30'd0, avalonst_source_endofpacket, avalonst_source_startofpacket};
    wire [WIDTH+31:0] written = {32'd0, avalonmm_write_slave_writedata};
    // verilator lint_on UNUSED
    wire [INFO-1:0] info = SINK != 0 ? {avalonst_sink_error, avalonst_sink_channel,
                                        avalonst_sink_empty, avalonst_sink_endofpacket,
                                        avalonst_sink_startofpacket} : info_q;
    wire [ALL-1:0]  data = {info, SINK != 0 ? avalonst_sink_data : avalonmm_write_slave_writedata};
    reg             asks_info_q;
    wire            read_clock = DUAL != 0 ? rdclock : wrclock;
    wire            read_rst_n = DUAL != 0 && RESETS == 2 ? rdreset_n : wrreset_n;
    wire [WIDTH+31:0] wide_info = {{WIDTH{1'b0}}, wide};

    assign {avalonst_source_error, avalonst_source_channel, avalonst_source_empty,
            avalonst_source_endofpacket, avalonst_source_startofpacket} = info_read;
    assign avalonmm_read_slave_readdata = asks_info_q ? wide_info[WIDTH-1:0] : turned;

    always @(posedge wrclock) begin
        was_ready_q <= wrreset_n && ready;
        if (avalonmm_write_slave_write && avalonmm_write_slave_address)
            info_q <= {written[16 +: ERROR], written[8 +: CHANNEL], written[2 +: EMPTY],
                       written[1:0]};
        else if (writes) info_q[1:0] <= 2'b00;
        if (!wrreset_n) info_q <= {INFO{1'b0}};
    end
    always @(posedge read_clock) begin
        asks_info_q           <= avalonmm_read_slave_read && avalonmm_read_slave_address;
        avalonst_source_valid <= read_rst_n && SOURCE != 0 && reads;
    end

    genvar n;
    generate
        if ((SINK != 0) != (SOURCE != 0)) begin : order
            for (n = 0; n < WIDTH; n = n + SYMBOL) begin : symbol
                assign turned[n +: SYMBOL] = q[WIDTH-SYMBOL-n +: SYMBOL];
            end
        end else begin : straight
            assign turned = q;
        end
    endgenerate

    // ---- Words and control slaves ----
    generate if (DUAL != 0) begin : dual
        wire            full, full_too, writes_seen;
        wire [LOG2-1:0] write_used, read_used;
        wire [LOG2:0]   read_level = {1'b0, read_used};
        wire            read_full  = full_too || read_level >= HIGHEST[LOG2:0] + 1'b1;

        assign write_level = {1'b0, write_used};
        assign write_full  = full || write_level >= HIGHEST[LOG2:0] + 1'b1;
        // verilator lint_off PINCONNECTEMPTY
        dcfifo #(
            .LPM_WIDTH(ALL), .LPM_WIDTHU(LOG2), .LPM_NUMWORDS(DEPTH)
        ) words (
            .aclr(!(wrreset_n && read_rst_n)), .wrclk(wrclock), .wrreq(writes), .data(data),
            .wrfull(full), .wrempty(write_empty), .wrusedw(write_used), .rdclk(rdclock),
            .rdreq(reads), .q({info_read, q}), .rdfull(full_too), .rdempty(read_empty),
            .rdusedw(read_used), .eccstatus()
        );
        // verilator lint_on PINCONNECTEMPTY
        altera_std_synchronizer #(.DEPTH(4)) write_sync (
            .clk(rdclock), .reset_n(read_rst_n), .din(asks_write), .dout(writes_seen)
        );
        altera_std_synchronizer #(.DEPTH(4)) read_sync (
            .clk(wrclock), .reset_n(wrreset_n), .din(asks_read), .dout(reads_seen)
        );
        de1sim_avalon_fifo_csr #(.LEVEL_BITS(LOG2 + 1), .HIGHEST(HIGHEST)) read_csr (
            .clk_i(rdclock), .rst_ni(read_rst_n), .level_i(read_level), .full_i(read_full),
            .empty_i(read_empty), .overflow_i(writes_seen && read_full),
            .underflow_i(asks_read && read_empty),
            .address_i(rdclk_control_slave_address), .read_i(rdclk_control_slave_read),
            .write_i(rdclk_control_slave_write), .writedata_i(rdclk_control_slave_writedata),
            .readdata_o(rdclk_control_slave_readdata), .irq_o(rdclk_control_slave_irq)
        );
    end else begin : single
        wire [LOG2-1:0] used;

        assign write_level = {write_full, used};
        assign write_empty = read_empty;
        assign reads_seen  = asks_read;
        assign rdclk_control_slave_readdata = 32'd0;
        assign rdclk_control_slave_irq      = 1'b0;
        // verilator lint_off PINCONNECTEMPTY
        scfifo #(
            .LPM_WIDTH(ALL), .LPM_WIDTHU(LOG2), .LPM_NUMWORDS(DEPTH),
            .USE_EAB(EAB != 0 ? "ON" : "OFF")
        ) words (
            .clock(wrclock), .aclr(!wrreset_n), .sclr(1'b0), .wrreq(writes), .data(data),
            .rdreq(reads), .q({info_read, q}), .usedw(used), .full(write_full), .empty(read_empty),
            .almost_full(), .almost_empty(), .eccstatus()
        );
        // verilator lint_on PINCONNECTEMPTY
    end endgenerate

    de1sim_avalon_fifo_csr #(.LEVEL_BITS(LOG2 + 1), .HIGHEST(HIGHEST)) write_csr (
        .clk_i(wrclock), .rst_ni(wrreset_n), .level_i(write_level), .full_i(write_full),
        .empty_i(write_empty), .overflow_i(asks_write && write_full),
        .underflow_i(reads_seen && write_empty),
        .address_i(wrclk_control_slave_address), .read_i(wrclk_control_slave_read),
        .write_i(wrclk_control_slave_write), .writedata_i(wrclk_control_slave_writedata),
        .readdata_o(wrclk_control_slave_readdata), .irq_o(wrclk_control_slave_irq)
    );
endmodule

`default_nettype wire
