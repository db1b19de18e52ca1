// altera_avalon_sgdma.v - Platform Designer's scatter-gather DMA controller
//
//   descriptor_read -> a descriptor -> m_read -> FIFO -> out, or m_write <- FIFO <- in
//   descriptor_write <- how it went
//
//   0 status   0 ERROR 1 EOP_ENCOUNTERED 2 DESCRIPTOR_COMPLETED 3 CHAIN_COMPLETED, which writing 1
//              clears, 4 BUSY
//   1 version, 1
//   4 control  0 to 3 each of these interrupts 4 IE_GLOBAL 5 RUN 6 STOP_DMA_ER
//              7 IE_MAX_DESC_PROCESSED 15:8 MAX_DESC_PROCESSED 16 SW_RESET, which is written twice
//              17 PARK 18 DESC_POLL_EN 31 CLEAR_INTERRUPT
//   8 next_descriptor_pointer
//
// A descriptor is eight words: 0 read address, 2 write address, 4 the next descriptor,
// 6 15:0 bytes, 0 = up to the end of the packet, 7 as it is written back: 15:0 bytes that were
// transferred, 22:16 errors, 23 ended by the packet, 24 GENERATE_EOP 25 READ_FIXED
// 26 WRITE_FIXED 31 OWNED_BY_HW, which is cleared, but not with PARK.
//
// RUN reads descriptors until one is not owned: then the chain is complete.  One is taken after
// the other.
//
// Source: Embedded Peripherals IP User Guide, Scatter-Gather DMA Controller Core, and its
// component's description.
//
// Not handled: bursts, which it asks for as single words; the bytes' order turned; the channel of a
// descriptor.

`default_nettype none

module altera_avalon_sgdma #(
    parameter WIDTH     = 32,
    parameter READS     = 1,
    parameter WRITES    = 1,
    parameter UNALIGNED = 0,
    parameter EMPTY     = 2,
    parameter ERROR     = 1,
    parameter COUNT     = 4,   // bits of burst counts, which are 1
    parameter BYTES     = WIDTH / 8
) (
    input  wire             clk,
    input  wire             system_reset_n,

    input  wire             csr_chipselect,
    input  wire [3:0]       csr_address,
    // verilator lint_off UNUSED
    input  wire             csr_read,
    // verilator lint_on UNUSED
    input  wire             csr_write,
    input  wire [31:0]      csr_writedata,
    output reg  [31:0]      csr_readdata,
    output wire             csr_irq,

    output wire [31:0]      descriptor_read_address,
    output wire             descriptor_read_read,
    output wire [3:0]       descriptor_read_burstcount,
    input  wire [31:0]      descriptor_read_readdata,
    input  wire             descriptor_read_readdatavalid,
    input  wire             descriptor_read_waitrequest,
    output wire [31:0]      descriptor_write_address,
    output wire             descriptor_write_write,
    output wire [31:0]      descriptor_write_writedata,
    input  wire             descriptor_write_waitrequest,

    output wire [31:0]      m_read_address,
    output wire             m_read_read,
    output wire [COUNT-1:0] m_read_burstcount,
    input  wire             m_read_waitrequest,
    input  wire             m_read_readdatavalid,
    input  wire [WIDTH-1:0] m_read_readdata,
    output wire [31:0]      m_write_address,
    output wire             m_write_write,
    output wire [WIDTH-1:0] m_write_writedata,
    output wire [BYTES-1:0] m_write_byteenable,
    output wire [COUNT-1:0] m_write_burstcount,
    input  wire             m_write_waitrequest,

    // verilator lint_off UNUSED
    input  wire             in_valid,
    input  wire [WIDTH-1:0] in_data,
    input  wire             in_startofpacket,
    input  wire             in_endofpacket,
    input  wire [EMPTY-1:0] in_empty,
    input  wire [ERROR-1:0] in_error,
    input  wire             out_ready,
    // verilator lint_on UNUSED
    output wire             in_ready,
    output wire             out_valid,
    output wire [WIDTH-1:0] out_data,
    output wire             out_startofpacket,
    output wire             out_endofpacket,
    output wire [EMPTY-1:0] out_empty,
    output wire [ERROR-1:0] out_error
);
    localparam JOINED = READS != 0 && WRITES != 0;
    localparam [2:0] IDLE = 3'd0, FETCH = 3'd1, CHECK = 3'd2, MOVES = 3'd3, BACK = 3'd4,
                     AGAIN = 3'd5;

    // ---- Registers --------------------------------------------------------
    reg  [2:0]  state_q;
    reg  [3:0]  status_q;
    reg  [18:0] control_q;
    reg  [31:0] next_q;        // descriptor
    reg  [7:0]  count_q;       // of descriptors, since RUN
    reg         irq_q, runs_q; // runs_q: the chain has not ended
    wire        writes   = csr_chipselect && csr_write;
    wire        restarts = writes && csr_address == 4'd4 && csr_writedata[16] && control_q[16];
    wire        rst      = !system_reset_n || restarts;
    reg         stops_q;       // what is under way ends, after SW_RESET
    wire        completes, has_error, by_packet, chain_ends;
    wire        read_busy, read_active, read_done, write_busy, write_active, write_done;
    wire [3:0]  events   = {chain_ends, completes, completes && by_packet, completes && has_error};
    wire        counts   = completes && control_q[7] && count_q + 8'd1 == control_q[15:8];

    assign csr_irq = irq_q;
    always @(posedge clk) begin
        case (csr_address)
            4'd0:    csr_readdata <= {27'd0, state_q != IDLE, status_q};
            4'd1:    csr_readdata <= 32'd1;
            4'd4:    csr_readdata <= {13'd0, control_q};
            4'd8:    csr_readdata <= next_q;
            default: csr_readdata <= 32'd0;
        endcase
        status_q <= (status_q & ~(writes && csr_address == 4'd0 ? csr_writedata[3:0] : 4'd0))
                    | events;
        if (writes && csr_address == 4'd4 && csr_writedata[31]) irq_q <= 1'b0;
        if (control_q[4] && ((events & control_q[3:0]) != 4'd0 || counts)) irq_q <= 1'b1;
        if (completes) count_q <= counts ? 8'd0 : count_q + 8'd1;
        if (writes && csr_address == 4'd4) begin
            control_q <= csr_writedata[18:0];
            runs_q    <= csr_writedata[5];
        end
        if (chain_ends || (completes && has_error && control_q[6])) runs_q <= 1'b0;
        stops_q <= restarts || (stops_q && (read_busy || read_active || write_busy
                                            || write_active));
        if (rst) begin
            {irq_q, runs_q} <= 2'b00;
            status_q  <= 4'd0;
            control_q <= 19'd0;
            count_q   <= 8'd0;
        end
    end

    // ---- A descriptor -----------------------------------------------------
    reg  [31:0] words_q [0:7];
    reg  [3:0]  asked_q, came_q;
    reg  [4:0]  pause_q;       // clocks until it is looked at again
    reg         ended_q;       // its packet has
    reg         inside_q;      // a packet to the stream has begun
    reg  [31:0] current_q;
    wire [7:0]  control  = words_q[7][31:24];
    wire [15:0] bytes    = words_q[6][15:0];
    wire        begins   = state_q == CHECK && control[7];
    // verilator lint_off UNUSED
    wire        early, sop;
    wire [7:0]  channel, error_out;
    wire [6:0]  lacks;
    wire [10:0] read_count, write_count;
    wire [31:0] written;
    wire [7:0]  errors;
    // verilator lint_on UNUSED
    wire [31:0] moved = WRITES != 0 ? written : {16'd0, bytes};

    assign descriptor_read_address    = {current_q[31:2], 2'b00} + {26'd0, asked_q, 2'b00};
    assign descriptor_read_read       = state_q == FETCH && !asked_q[3] && asked_q == came_q;
    assign descriptor_read_burstcount = 4'd1;
    assign descriptor_write_address   = {current_q[31:2], 2'b00} + 32'd28;
    assign descriptor_write_write     = state_q == BACK;
    assign descriptor_write_writedata = {control[7] && control_q[17], control[6:0], by_packet,
                                         errors[6:0], moved[15:0]};
    assign has_error  = WRITES != 0 && READS == 0 && errors[6:0] != 7'd0;
    assign by_packet  = WRITES != 0 && READS == 0 && ended_q;
    assign completes  = state_q == BACK && !descriptor_write_waitrequest;
    assign chain_ends = state_q == CHECK && !control[7] && !control_q[18];

    always @(posedge clk) begin
        if (descriptor_read_read && !descriptor_read_waitrequest) asked_q <= asked_q + 4'd1;
        if (descriptor_read_readdatavalid) begin
            words_q[came_q[2:0]] <= descriptor_read_readdata;
            came_q <= came_q + 4'd1;
        end
        pause_q <= pause_q + 5'd1;
        case (state_q)
            IDLE:
                if (runs_q && control_q[5] && !stops_q && asked_q == came_q) begin
                    state_q   <= FETCH;
                    current_q <= next_q;
                    {asked_q, came_q} <= 8'd0;
                end
            FETCH: if (came_q[3]) state_q <= CHECK;
            CHECK: begin
                pause_q <= 5'd0;
                state_q <= control[7] ? MOVES : control_q[18] ? AGAIN : IDLE;
                next_q  <= control[7] ? words_q[4] : current_q;
            end
            MOVES: if (WRITES != 0 ? write_done : read_done) begin
                state_q  <= BACK;
                ended_q  <= !early;
                inside_q <= !control[0];
            end
            BACK: if (!descriptor_write_waitrequest) state_q <= IDLE;
            default: if (pause_q[4]) state_q <= IDLE;
        endcase
        if (writes && csr_address == 4'd8) next_q <= csr_writedata;
        if (rst) begin
            state_q  <= IDLE;
            next_q   <= 32'd0;
            inside_q <= 1'b0;
        end
        if (!system_reset_n) {asked_q, came_q} <= 8'd0;
    end

    // ---- Masters ----------------------------------------------------------
    wire             valid, ready, sink_ready;
    wire [WIDTH-1:0] data;
    generate
        if (READS != 0) begin : reads
            de1sim_msgdma_read #(
                .WIDTH(WIDTH), .LENGTH(17), .FIFO_LOG2(6), .STRIDES(1), .UNALIGNED(UNALIGNED)
            ) master (
                .clk_i(clk), .clear_i(!system_reset_n), .rst_i(stops_q), .pause_i(1'b0),
                .busy_o(read_busy), .reads_o(read_active), .go_i(begins), .address_i(words_q[0]),
                .length_i({16'd0, bytes}), .burst_i(8'd0), .stride_i({15'd0, !control[1]}),
                .channel_i(8'd0), .error_i(8'd0), .sop_i(!inside_q), .eop_i(control[0]),
                .done_o(read_done), .address_o(m_read_address), .read_o(m_read_read),
                .burstcount_o(read_count), .waitrequest_i(m_read_waitrequest),
                .readdatavalid_i(m_read_readdatavalid), .readdata_i(m_read_readdata),
                .valid_o(valid), .ready_i(ready), .data_o(data), .sop_o(sop),
                .eop_o(out_endofpacket), .empty_o(lacks), .channel_o(channel),
                .error_o(error_out)
            );
        end else begin : no_reads
            assign {read_busy, read_active, read_done, m_read_read, valid, sop, out_endofpacket}
                = 7'd0;
            assign m_read_address = 32'd0;
            assign read_count     = 11'd0;
            assign lacks          = 7'd0;
            assign {channel, error_out} = 16'd0;
            assign data           = {WIDTH{1'b0}};
        end
        if (WRITES != 0) begin : writing
            de1sim_msgdma_write #(
                .WIDTH(WIDTH), .LENGTH(17), .FIFO_LOG2(6), .STRIDES(1), .UNALIGNED(UNALIGNED),
                .PACKETS(1)
            ) master (
                .clk_i(clk), .clear_i(!system_reset_n), .rst_i(stops_q), .pause_i(1'b0),
                .busy_o(write_busy), .writes_o(write_active), .go_i(begins),
                .address_i(words_q[2]),
                .length_i(bytes == 16'd0 && !JOINED ? 32'h10000 : {16'd0, bytes}),
                .burst_i(8'd0), .stride_i({15'd0, !control[2]}), .end_on_eop_i(!JOINED),
                .done_o(write_done), .written_o(written), .error_o(errors), .early_o(early),
                .address_o(m_write_address), .write_o(m_write_write),
                .writedata_o(m_write_writedata), .byteenable_o(m_write_byteenable),
                .burstcount_o(write_count), .waitrequest_i(m_write_waitrequest),
                .valid_i(JOINED ? valid : in_valid), .ready_o(sink_ready),
                .data_i(JOINED ? data : in_data), .eop_i(!JOINED && in_endofpacket),
                .empty_i({{7-EMPTY{1'b0}}, in_empty}),
                .error_i(JOINED ? 8'd0 : {{8-ERROR{1'b0}}, in_error})
            );
        end else begin : no_writing
            assign {write_busy, write_active, write_done, m_write_write, sink_ready, early} = 6'd0;
            assign {m_write_address, written} = 64'd0;
            assign m_write_writedata  = {WIDTH{1'b0}};
            assign m_write_byteenable = {BYTES{1'b0}};
            assign write_count        = 11'd0;
            assign errors             = 8'd0;
        end
    endgenerate
    assign ready     = JOINED ? sink_ready : out_ready;
    assign in_ready  = sink_ready && !JOINED;
    assign out_valid = valid && !JOINED;
    assign out_data  = data;
    assign out_startofpacket  = sop;
    assign out_empty          = lacks[EMPTY-1:0];
    assign out_error          = {ERROR{1'b0}};
    assign m_read_burstcount  = 1;
    assign m_write_burstcount = 1;
endmodule

`default_nettype wire
