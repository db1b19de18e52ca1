// altera_msgdma.v - Platform Designer's modular scatter-gather DMA
//
//   descriptor_slave -> descriptors -+-> read master  -> st_source, or
//                                    |                      v
//                                    +-> write master <- st_sink
//                                             +-> responses, csr_irq
//
// A descriptor is four words, or eight with ENHANCED_FEATURES, and taken with the GO bit:
//
//   read address, write address, length, [burst counts and sequence number, strides, two upper
//   halves of addresses, which are 0,] control
//
//   control: 7:0 channel 8 sop 9 eop 10 park reads 11 park writes 12 end on eop 14 interrupt when
//   complete 15 on early termination 23:16 on these errors; the errors that the stream gets 31 GO
//
//   csr: 0 status   0 busy 1 descriptors empty 2 full 3 responses empty 4 full 5 stopped
//                   6 resetting 7 stopped on error 8 on early termination 9 irq, writing 1 clears
//                   31:16 interrupts, writing bit 16 clears
//        1 control  0 stop 1 reset 2 stop on error 3 on early termination 4 interrupts 5 stop
//                   descriptors
//        2 descriptors waiting: 15:0 to be read, 31:16 to be written    3 responses
//        4 sequence number: 15:0 of reads, 31:16 of writes, with ENHANCED_FEATURES
//
//   response: 0 bytes written, with packets   1 7:0 errors 8 early termination; a read of its last
//             byte takes it away
//
// A parked descriptor is repeated until there is another.  A command of memory to a stream is
// complete when its data are in the FIFO.
//
// Source: Embedded Peripherals IP User Guide, Modular Scatter-Gather DMA Core, and its Verilog.
//
// Not handled: the prefetcher; addresses above 32 bits; the registers of its configuration, which
// are 0; early done; bursts of packets that end on eop.

`default_nettype none

module altera_msgdma #(
    parameter MODE        = 0,    // 0 memory to memory, 1 memory to stream, 2 stream to memory
    parameter DATA_WIDTH  = 32,
    parameter FIFO_LOG2   = 5,
    parameter DEPTH_LOG2  = 7,    // of the descriptors
    parameter LENGTH      = 11,   // bits
    parameter ENHANCED    = 0,
    parameter BURST       = 1,
    parameter WRAPS       = 0,
    parameter PROGRAMS    = 0,
    parameter STRIDES     = 0,
    parameter UNALIGNED   = 0,
    parameter WHOLE       = 0,
    parameter PACKETS     = 0,
    parameter RESPONSES   = 2,    // 0 = by the slave, 1 = by the stream, 2 = none
    parameter EXPOSED     = 0,
    parameter ERROR_WIDTH   = 8,
    parameter CHANNEL_WIDTH = 8,
    parameter COUNT_WIDTH   = 1,
    parameter EMPTY_WIDTH   = 2,
    parameter BYTES       = DATA_WIDTH / 8,
    parameter WORDS       = ENHANCED != 0 ? 8 : 4
) (
    input  wire                     clock,
    input  wire                     reset_n,

    input  wire [2:0]               csr_address,
    input  wire                     csr_read,
    input  wire                     csr_write,
    // verilator lint_off UNUSED
    input  wire [3:0]               csr_byteenable,
    // verilator lint_on UNUSED
    input  wire [31:0]              csr_writedata,
    output reg  [31:0]              csr_readdata,
    output wire                     csr_irq,

    input  wire                     descriptor_write,
    input  wire [4*WORDS-1:0]       descriptor_byteenable,
    input  wire [32*WORDS-1:0]      descriptor_writedata,
    output wire                     descriptor_waitrequest,

    input  wire                     response_address,
    input  wire                     response_read,
    // verilator lint_off UNUSED
    input  wire [3:0]               response_byteenable,
    // verilator lint_on UNUSED
    output wire [31:0]              response_readdata,
    output wire                     response_waitrequest,
    output wire [255:0]             src_response_data,
    output wire                     src_response_valid,
    // verilator lint_off UNUSED
    input  wire                     src_response_ready,
    // verilator lint_on UNUSED

    output wire [31:0]              read_address,
    output wire                     read_read,
    output wire [BYTES-1:0]         read_byteenable,
    output wire [COUNT_WIDTH-1:0]   read_burstcount,
    input  wire                     read_waitrequest,
    input  wire                     read_readdatavalid,
    input  wire [DATA_WIDTH-1:0]    read_readdata,

    output wire [31:0]              write_address,
    output wire                     write_write,
    output wire [BYTES-1:0]         write_byteenable,
    output wire [DATA_WIDTH-1:0]    write_writedata,
    output wire [COUNT_WIDTH-1:0]   write_burstcount,
    input  wire                     write_waitrequest,

    output wire                     src_valid,
    // verilator lint_off UNUSED
    input  wire                     src_ready,
    // verilator lint_on UNUSED
    output wire [DATA_WIDTH-1:0]    src_data,
    output wire                     src_startofpacket,
    output wire                     src_endofpacket,
    output wire [EMPTY_WIDTH-1:0]   src_empty,
    output wire [ERROR_WIDTH-1:0]   src_error,
    output wire [CHANNEL_WIDTH-1:0] src_channel,

    // verilator lint_off UNUSED
    input  wire                     snk_valid,
    input  wire [DATA_WIDTH-1:0]    snk_data,
    input  wire                     snk_startofpacket,
    input  wire                     snk_endofpacket,
    input  wire [EMPTY_WIDTH-1:0]   snk_empty,
    input  wire [ERROR_WIDTH-1:0]   snk_error,
    // verilator lint_on UNUSED
    output wire                     snk_ready
);
    localparam READS = MODE != 2, WRITES = MODE != 1, JOINED = MODE == 0 && EXPOSED == 0;
    localparam [DEPTH_LOG2:0] FULL = 1 << DEPTH_LOG2;

    wire rst = !reset_n;

    // ---- Registers --------------------------------------------------------
    reg         resets_q, on_error_q, on_early_q, irq_q;
    reg  [5:0]  control_q;
    reg  [15:0] irqs_q;
    wire        complete, with_error, with_early, interrupts;
    wire        busy, empty, full, stopped, resetting;
    wire [31:0] waiting, responses, sequence_number;
    wire        responses_empty, responses_full;
    wire        to_control = csr_write && csr_address == 3'd1 && csr_byteenable[0];
    wire        stops_error = complete && control_q[2] && with_error;
    wire        stops_early = complete && control_q[3] && with_early;

    assign csr_irq = irq_q;
    always @(posedge clock) begin
        if (csr_read)
            case (csr_address)
                3'd0:    csr_readdata <= {irqs_q, 6'd0, irq_q, on_early_q, on_error_q, resetting,
                                          stopped, responses_full, responses_empty, full, empty,
                                          busy};
                3'd1:    csr_readdata <= {26'd0, control_q};
                3'd2:    csr_readdata <= waiting;
                3'd3:    csr_readdata <= responses;
                3'd4:    csr_readdata <= ENHANCED != 0 ? sequence_number : 32'd0;
                default: csr_readdata <= 32'd0;
            endcase
        if (csr_write && csr_address == 3'd0) begin
            if (csr_byteenable[1] && csr_writedata[9]) irq_q <= 1'b0;
            if (csr_byteenable[2] && csr_writedata[16]) irqs_q <= 16'd0;
        end
        if (complete && interrupts && control_q[4]) begin
            irq_q  <= 1'b1;
            irqs_q <= irqs_q + 16'd1;
        end
        if (to_control) begin
            control_q <= csr_writedata[5:0];
            if (!csr_writedata[0]) {on_error_q, on_early_q} <= 2'b00;
            if (csr_writedata[1]) resets_q <= 1'b1;
        end
        if (stops_error || stops_early) begin
            control_q[0] <= 1'b1;
            on_error_q   <= on_error_q || stops_error;
            on_early_q   <= on_early_q || stops_early;
        end
        if (control_q[1]) begin
            control_q <= 6'd0;
            irq_q     <= 1'b0;
            irqs_q    <= 16'd0;
            {on_error_q, on_early_q} <= 2'b00;
        end else if (resets_q && !resetting) resets_q <= 1'b0;
        if (rst) begin
            control_q <= 6'd0;
            irqs_q    <= 16'd0;
            {irq_q, resets_q, on_error_q, on_early_q} <= 4'd0;
        end
    end

    // ---- Descriptors ------------------------------------------------------
    reg  [32*WORDS-1:0] descriptors_q [0:(1<<DEPTH_LOG2)-1];
    reg  [32*WORDS-1:0] next_q;                 // as far as it has been written
    reg  [DEPTH_LOG2:0] in_q, read_q, write_q;
    reg  [32*WORDS-1:0] written;
    reg  [15:0]         read_number_q, write_number_q;
    reg  [9:0]          masks_q;                // of the command: complete, early, errors
    wire [DEPTH_LOG2:0] reads_used  = READS ? in_q - read_q : 0;
    wire [DEPTH_LOG2:0] writes_used = WRITES ? in_q - write_q : 0;
    wire [32*WORDS-1:0] read_next   = descriptors_q[read_q[DEPTH_LOG2-1:0]];
    wire [32*WORDS-1:0] write_next  = descriptors_q[write_q[DEPTH_LOG2-1:0]];
    wire [31:0]         read_control  = read_next[32*WORDS-1 -: 32];
    wire [31:0]         write_control = write_next[32*WORDS-1 -: 32];
    wire [31:0]         read_bursts   = ENHANCED != 0 ? read_next[127:96] : 32'd0;
    wire [31:0]         write_bursts  = ENHANCED != 0 ? write_next[127:96] : 32'd0;
    wire                read_busy, write_busy, read_active, write_active, read_done, write_done;
    wire                issues = !control_q[0] && !control_q[5] && !resets_q && !responses_full;
    wire                read_go  = issues && reads_used != 0 && !read_busy;
    wire                write_go = issues && writes_used != 0 && !write_busy;
    wire                taken  = descriptor_write && !descriptor_waitrequest;
    wire                go     = taken && descriptor_byteenable[4*WORDS-1] && written[32*WORDS-1];

    assign full      = reads_used == FULL || writes_used == FULL;
    assign empty     = reads_used == 0 && writes_used == 0;
    assign resetting = resets_q && (control_q[1] || read_busy || read_active || write_busy
                                    || write_active);
    assign busy      = !empty || read_busy || write_busy || resets_q;
    assign stopped   = (control_q[0] && !read_active && !write_active)
                       || (control_q[5] && !read_busy && !write_busy);
    assign waiting   = {{15-DEPTH_LOG2{1'b0}}, writes_used, {15-DEPTH_LOG2{1'b0}}, reads_used};
    assign sequence_number = {write_number_q, read_number_q};
    assign descriptor_waitrequest = full || resets_q;
    assign complete   = !resets_q && (MODE == 1 ? read_done : write_done);
    assign interrupts = masks_q[9] || (MODE == 2 && ((with_early && masks_q[8])
                                                     || (write_error & masks_q[7:0]) != 8'd0));

    integer n;
    always @* begin
        written = next_q;
        for (n = 0; n < 4 * WORDS; n = n + 1)
            if (descriptor_byteenable[n]) written[8*n +: 8] = descriptor_writedata[8*n +: 8];
    end
    always @(posedge clock) begin
        if (taken) next_q <= written;
        if (go) begin
            descriptors_q[in_q[DEPTH_LOG2-1:0]] <= written;
            in_q <= in_q + 1'b1;
        end
        // Parked: alone, it stays.
        if (read_go) begin
            read_number_q <= read_bursts[15:0];
            if (!(read_control[10] && reads_used == 1)) read_q <= read_q + 1'b1;
        end
        if (write_go) begin
            write_number_q <= write_bursts[15:0];
            if (!(write_control[11] && writes_used == 1)) write_q <= write_q + 1'b1;
        end
        if (MODE == 1 ? read_go : write_go)
            masks_q <= MODE == 1 ? {read_control[14], 9'd0}
                                 : {write_control[14], write_control[15], write_control[23:16]};
        if (rst || resets_q) {in_q, read_q, write_q} <= 0;
        if (rst) {read_number_q, write_number_q} <= 32'd0;
    end

    // ---- Masters ----------------------------------------------------------
    wire                  valid, ready, sop, eop, sink_ready;
    wire [DATA_WIDTH-1:0] data;
    wire [6:0]            lacks;
    wire [7:0]            channel, error, write_error;
    // verilator lint_off UNUSED
    wire [10:0]           read_count, write_count;
    wire [31:0]           bytes_written;
    // verilator lint_on UNUSED
    wire                  early;

    generate
        if (READS) begin : reads
            de1sim_msgdma_read #(
                .WIDTH(DATA_WIDTH), .LENGTH(LENGTH), .FIFO_LOG2(FIFO_LOG2), .BURST(BURST),
                .WRAPS(WRAPS), .PROGRAMS(PROGRAMS), .STRIDES(STRIDES), .UNALIGNED(UNALIGNED)
            ) master (
                .clk_i(clock), .clear_i(rst), .rst_i(resets_q), .pause_i(control_q[0]),
                .busy_o(read_busy), .reads_o(read_active), .go_i(read_go),
                .address_i(read_next[31:0]), .length_i(read_next[95:64]),
                .burst_i(read_bursts[23:16]),
                .stride_i(ENHANCED != 0 ? read_next[32*WORDS-128 +: 16] : 16'd1),
                .channel_i(read_control[7:0]), .error_i(read_control[23:16]),
                .sop_i(read_control[8] && PACKETS != 0), .eop_i(read_control[9] && PACKETS != 0),
                .done_o(read_done), .address_o(read_address), .read_o(read_read),
                .burstcount_o(read_count), .waitrequest_i(read_waitrequest),
                .readdatavalid_i(read_readdatavalid), .readdata_i(read_readdata),
                .valid_o(valid), .ready_i(ready), .data_o(data), .sop_o(sop), .eop_o(eop),
                .empty_o(lacks), .channel_o(channel), .error_o(error)
            );
        end else begin : none
            assign {read_busy, read_active, read_done, read_read, valid, sop, eop} = 7'd0;
            assign read_address = 32'd0;
            assign data         = {DATA_WIDTH{1'b0}};
            assign lacks        = 7'd0;
            assign read_count   = 11'd0;
            assign {channel, error} = 16'd0;
        end
        if (WRITES) begin : writes
            de1sim_msgdma_write #(
                .WIDTH(DATA_WIDTH), .LENGTH(LENGTH), .FIFO_LOG2(FIFO_LOG2), .BURST(BURST),
                .WRAPS(WRAPS), .PROGRAMS(PROGRAMS), .STRIDES(STRIDES), .UNALIGNED(UNALIGNED),
                .WHOLE(WHOLE), .PACKETS(PACKETS)
            ) master (
                .clk_i(clock), .clear_i(rst), .rst_i(resets_q), .pause_i(control_q[0]),
                .busy_o(write_busy), .writes_o(write_active), .go_i(write_go),
                .address_i(write_next[63:32]), .length_i(write_next[95:64]),
                .burst_i(write_bursts[31:24]),
                .stride_i(ENHANCED != 0 ? write_next[32*WORDS-112 +: 16] : 16'd1),
                .end_on_eop_i(write_control[12]), .done_o(write_done), .written_o(bytes_written),
                .error_o(write_error), .early_o(early), .address_o(write_address),
                .write_o(write_write), .writedata_o(write_writedata),
                .byteenable_o(write_byteenable), .burstcount_o(write_count),
                .waitrequest_i(write_waitrequest),
                .valid_i(JOINED ? valid : snk_valid), .ready_o(sink_ready),
                .data_i(JOINED ? data : snk_data), .eop_i(snk_endofpacket),
                .empty_i({{7-EMPTY_WIDTH{1'b0}}, snk_empty}),
                .error_i(JOINED ? 8'd0 : {{8-ERROR_WIDTH{1'b0}}, snk_error})
            );
        end else begin : no_writes
            assign {write_busy, write_active, write_done, write_write, sink_ready, early} = 6'd0;
            assign {write_address, bytes_written} = 64'd0;
            assign write_writedata  = {DATA_WIDTH{1'b0}};
            assign write_byteenable = {BYTES{1'b0}};
            assign write_count      = 11'd0;
            assign write_error      = 8'd0;
        end
    endgenerate
    assign ready       = JOINED ? sink_ready : src_ready;
    assign with_error  = write_error != 8'd0;
    assign with_early  = early;
    assign snk_ready   = sink_ready && !JOINED;
    assign src_valid   = valid && !JOINED;
    assign src_data    = data;
    assign src_empty   = lacks[EMPTY_WIDTH-1:0];
    assign src_error   = error[ERROR_WIDTH-1:0];
    assign src_channel = channel[CHANNEL_WIDTH-1:0];
    assign {src_startofpacket, src_endofpacket} = {sop, eop};
    assign read_byteenable  = {BYTES{1'b1}};
    assign read_burstcount  = read_count[COUNT_WIDTH-1:0];
    assign write_burstcount = write_count[COUNT_WIDTH-1:0];

    // ---- Responses --------------------------------------------------------
    generate
        if (RESPONSES != 2 && MODE != 1) begin : has_responses
            localparam [DEPTH_LOG2+1:0] MOST = 2 << DEPTH_LOG2;
            reg  [50:0]         list_q [0:(2<<DEPTH_LOG2)-1];
            reg  [DEPTH_LOG2+1:0] first_q, last_q;
            wire [DEPTH_LOG2+1:0] used = last_q - first_q;
            wire [50:0]         first = list_q[first_q[DEPTH_LOG2:0]];
            wire                pops  = used != 0 && (RESPONSES == 1 ? src_response_ready
                                        : response_read && response_address
                                          && response_byteenable[3]);

            assign responses       = {{30-DEPTH_LOG2{1'b0}}, used};
            assign responses_empty = used == 0;
            assign responses_full  = used >= MOST - 1;
            assign response_waitrequest = used == 0;
            assign response_readdata    = response_address ? {23'd0, first[40:32]} : first[31:0];
            assign src_response_valid   = used != 0;
            assign src_response_data    = {205'd0, first};
            always @(posedge clock) begin
                if (complete)
                    list_q[last_q[DEPTH_LOG2:0]] <= {masks_q[8:0], masks_q[9], early, write_error,
                                                     bytes_written};
                last_q  <= last_q + {{DEPTH_LOG2+1{1'b0}}, complete};
                first_q <= first_q + {{DEPTH_LOG2+1{1'b0}}, pops};
                if (rst || resets_q) {first_q, last_q} <= 0;
            end
        end else begin : no_responses
            assign responses         = 32'd0;
            assign {responses_empty, responses_full} = 2'b00;
            assign response_waitrequest = 1'b0;
            assign response_readdata = 32'd0;
            assign src_response_valid = 1'b0;
            assign src_response_data = 256'd0;
        end
    endgenerate
endmodule

`default_nettype wire
