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
// slave's its lowest.
//
// Registers: de1sim_avalon_fifo_csr.v.
//
// Source: Embedded Peripherals IP User Guide, Avalon FIFO Memory Core, and the Verilog that it
// generates.
//
// Not handled: packets, channels and errors of streams.

`default_nettype none

module altera_avalon_fifo #(
    parameter WIDTH  = 32,
    parameter LOG2   = 4,
    parameter DUAL   = 0,
    parameter RESETS = 2,    // with DUAL; 1 = wrreset_n resets both sides
    parameter SINK   = 0,    // 1 = a stream comes in
    parameter SOURCE = 0,    // 1 = a stream goes out
    parameter SYMBOL = 8,
    parameter WAITS  = 1     // 0 = without backpressure: the stream that goes out is always ready
) (
    input  wire             wrclock,
    input  wire             wrreset_n,
    // verilator lint_off UNUSED
    input  wire             rdclock,       // with DUAL
    input  wire             rdreset_n,
    // verilator lint_on UNUSED

    input  wire             avalonmm_write_slave_write,
    input  wire [WIDTH-1:0] avalonmm_write_slave_writedata,
    output wire             avalonmm_write_slave_waitrequest,
    input  wire             avalonst_sink_valid,
    input  wire [WIDTH-1:0] avalonst_sink_data,
    output wire             avalonst_sink_ready,

    input  wire             avalonmm_read_slave_read,
    output wire [WIDTH-1:0] avalonmm_read_slave_readdata,
    output wire             avalonmm_read_slave_waitrequest,
    output wire             avalonst_source_valid,
    output wire [WIDTH-1:0] avalonst_source_data,
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
    localparam AHEAD = SOURCE != 0 ? "ON" : "OFF";

    wire [WIDTH-1:0] data = SINK != 0 ? avalonst_sink_data : avalonmm_write_slave_writedata;
    wire [WIDTH-1:0] q, turned;
    wire             write_full, write_empty, read_empty;
    wire [LOG2:0]    write_level;
    wire             reads_seen;   // by the side of the writes
    wire             asks_write = SINK != 0 ? avalonst_sink_valid : avalonmm_write_slave_write;
    wire             asks_read  = SOURCE != 0 ? avalonst_source_ready || WAITS == 0
                                              : avalonmm_read_slave_read;
    wire             writes = asks_write && !write_full;
    wire             reads  = asks_read && !read_empty;

    assign avalonmm_write_slave_waitrequest = write_full;
    assign avalonst_sink_ready              = !write_full;
    assign avalonmm_read_slave_waitrequest  = read_empty;
    assign avalonmm_read_slave_readdata     = turned;
    assign avalonst_source_valid            = !read_empty;
    assign avalonst_source_data             = turned;

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
        wire            read_rst_n = RESETS == 2 ? rdreset_n : wrreset_n;
        wire            full, full_too, writes_seen;
        wire [LOG2-1:0] write_used, read_used;
        wire [LOG2:0]   read_level = {1'b0, read_used};
        wire            read_full  = full_too || read_level >= HIGHEST[LOG2:0] + 1'b1;

        assign write_level = {1'b0, write_used};
        assign write_full  = full || write_level >= HIGHEST[LOG2:0] + 1'b1;
        // verilator lint_off PINCONNECTEMPTY
        dcfifo #(
            .LPM_WIDTH(WIDTH), .LPM_WIDTHU(LOG2), .LPM_NUMWORDS(DEPTH), .LPM_SHOWAHEAD(AHEAD)
        ) words (
            .aclr(!(wrreset_n && read_rst_n)), .wrclk(wrclock), .wrreq(writes), .data(data),
            .wrfull(full), .wrempty(write_empty), .wrusedw(write_used), .rdclk(rdclock),
            .rdreq(reads), .q(q), .rdfull(full_too), .rdempty(read_empty), .rdusedw(read_used),
            .eccstatus()
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
            .LPM_WIDTH(WIDTH), .LPM_WIDTHU(LOG2), .LPM_NUMWORDS(DEPTH), .LPM_SHOWAHEAD(AHEAD)
        ) words (
            .clock(wrclock), .aclr(!wrreset_n), .sclr(1'b0), .wrreq(writes), .data(data),
            .rdreq(reads), .q(q), .usedw(used), .full(write_full), .empty(read_empty),
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
