// de1sim_msgdma_read.v - the read master of Platform Designer's mSGDMA: memory to a stream
//
//   command -> reads, of as many words as have room -> beats -> FIFO -> stream
//
// The byte of the lowest address is a beat's first symbol, its highest.  With UNALIGNED the first
// byte may be anywhere in a word, else the word's lower address bits are 0.  The command is done
// when all its data are in the FIFO.

`default_nettype none

module de1sim_msgdma_read #(
    parameter WIDTH     = 32,
    parameter LENGTH    = 11,   // bits
    parameter FIFO_LOG2 = 5,
    parameter BURST     = 1,    // most words of a burst
    parameter WRAPS     = 0,    // 1 = a burst begins at a multiple of its length
    parameter PROGRAMS  = 0,    // 1 = the command has its own BURST
    parameter STRIDES   = 0,
    parameter UNALIGNED = 0,
    parameter BYTES     = WIDTH / 8
) (
    input  wire             clk_i,
    input  wire             clear_i,
    input  wire             rst_i,      // ends the command, when what is under way has come
    input  wire             pause_i,
    output wire             busy_o,     // with a command
    output wire             reads_o,    // something of a read is under way

    input  wire             go_i,
    input  wire [31:0]      address_i,
    // verilator lint_off UNUSED
    input  wire [31:0]      length_i,
    // verilator lint_on UNUSED
    input  wire [7:0]       burst_i,
    input  wire [15:0]      stride_i,
    input  wire [7:0]       channel_i,
    input  wire [7:0]       error_i,
    input  wire             sop_i,
    input  wire             eop_i,
    output wire             done_o,

    output reg  [31:0]      address_o,
    output reg              read_o,
    output reg  [10:0]      burstcount_o,
    input  wire             waitrequest_i,
    input  wire             readdatavalid_i,
    input  wire [WIDTH-1:0] readdata_i,

    output wire             valid_o,
    input  wire             ready_i,
    output wire [WIDTH-1:0] data_o,
    output wire             sop_o,
    output wire             eop_o,
    output wire [6:0]       empty_o,
    output wire [7:0]       channel_o,
    output wire [7:0]       error_o
);
    localparam LOW  = BYTES - 1;             // of an address, within a word
    localparam [31:0] MASK = LOW, DEPTH = 1 << FIFO_LOG2;
    localparam [31:0] ALL = 32'hffffffff >> (32 - LENGTH);
    localparam SIDE = 2 + 7 + 16, ENTRY = SIDE + WIDTH;

    // ---- A command, and its reads ----
    reg         busy_q, last_q;              // last_q: what is left is a beat without another word
    reg  [31:0] next_q, words_q, left_q;     // words to be asked for, bytes to be put in the FIFO
    reg  [31:0] expected_q;                  // words that are to come
    reg  [31:0] offset_q;
    reg  [7:0]  burst_q, channel_q, error_q;
    reg  [15:0] stride_q;
    reg         sop_q, eop_q, primed_q;
    reg  [WIDTH-1:0] before_q;               // the word before, of which some bytes are left

    wire [31:0] length = length_i & ALL;
    wire [31:0] offset = UNALIGNED != 0 ? address_i & MASK : 32'd0;
    wire [31:0] most   = PROGRAMS != 0 && burst_q != 8'd0 && {24'd0, burst_q} < BURST
                         ? {24'd0, burst_q} : BURST;
    wire [31:0] aligned = WRAPS != 0 && (next_q & (BURST * BYTES - 1)) != 32'd0 ? 32'd1 : most;
    wire [31:0] count  = words_q < aligned ? words_q : aligned;
    wire [FIFO_LOG2:0] used;
    wire        room   = {{31-FIFO_LOG2{1'b0}}, used} + expected_q + count <= DEPTH;
    wire        taken  = read_o && !waitrequest_i;

    assign busy_o  = busy_q;
    assign reads_o = read_o || expected_q != 32'd0;

    // ---- Beats ----
    wire [2*WIDTH-1:0] both = {readdata_i, before_q};
    // verilator lint_off UNUSED
    wire [2*WIDTH-1:0] joined = (last_q ? {{WIDTH{1'b0}}, before_q} : both) >> offset_q * 8;
    // verilator lint_on UNUSED
    wire [WIDTH-1:0] word   = offset_q == 32'd0 ? readdata_i : joined[WIDTH-1:0];
    wire             primes = readdatavalid_i && offset_q != 32'd0 && !primed_q;
    wire             beat   = busy_q && (last_q || (readdatavalid_i && !primes));
    wire             ends   = left_q <= BYTES;
    wire             eop    = ends && eop_q;
    wire [31:0]      lacks  = BYTES - left_q;
    wire [WIDTH-1:0] turned;
    genvar n;
    generate
        for (n = 0; n < WIDTH; n = n + 8) begin : symbol
            assign turned[n +: 8] = word[WIDTH-8-n +: 8];
        end
    endgenerate
    assign done_o = busy_q && ((beat && ends) || left_q == 32'd0);

    always @(posedge clk_i) begin
        expected_q <= expected_q + (taken ? {21'd0, burstcount_o} : 32'd0)
                      - {31'd0, readdatavalid_i};
        if (taken) read_o <= 1'b0;
        if (busy_q && !read_o && words_q != 32'd0 && room && !pause_i && !rst_i) begin
            read_o       <= 1'b1;
            address_o    <= next_q;
            burstcount_o <= count[10:0];
            words_q      <= words_q - count;
            next_q       <= next_q + count * BYTES * (STRIDES != 0 ? {16'd0, stride_q} : 32'd1);
        end
        if (readdatavalid_i) begin
            before_q <= readdata_i;
            primed_q <= 1'b1;
        end
        // The last word may have more than the last beat.
        last_q <= busy_q && readdatavalid_i && expected_q == 32'd1 && words_q == 32'd0 && !read_o
                  && (beat ? left_q > BYTES : left_q != 32'd0);
        if (beat) begin
            left_q <= ends ? 32'd0 : left_q - BYTES;
            sop_q  <= 1'b0;
        end
        if (done_o) busy_q <= 1'b0;
        if (go_i) begin
            busy_q    <= 1'b1;
            next_q    <= address_i & ~MASK;
            words_q   <= (length + offset + MASK) / BYTES;
            left_q    <= length;
            offset_q  <= offset;
            burst_q   <= burst_i;
            stride_q  <= stride_i;
            channel_q <= channel_i;
            error_q   <= error_i;
            {sop_q, eop_q, primed_q} <= {sop_i, eop_i, 1'b0};
        end
        if (rst_i) begin
            // What has been asked for still comes.
            {busy_q, last_q} <= 2'b00;
            words_q <= 32'd0;
        end
        if (clear_i) begin
            {busy_q, last_q, read_o} <= 3'b000;
            words_q    <= 32'd0;
            expected_q <= 32'd0;
        end
    end

    // ---- The FIFO ----
    reg  [ENTRY-1:0]   entries_q [0:(1<<FIFO_LOG2)-1];
    reg  [FIFO_LOG2:0] in_q, out_q;
    wire [ENTRY-1:0]   first = entries_q[out_q[FIFO_LOG2-1:0]];

    assign used    = in_q - out_q;
    assign valid_o = used != 0;
    assign {sop_o, eop_o, empty_o, channel_o, error_o, data_o} = first;
    always @(posedge clk_i) begin
        if (beat) entries_q[in_q[FIFO_LOG2-1:0]] <= {sop_q, eop, eop ? lacks[6:0] : 7'd0,
                                                     channel_q, error_q, turned};
        in_q  <= in_q + {{FIFO_LOG2{1'b0}}, beat};
        out_q <= out_q + {{FIFO_LOG2{1'b0}}, valid_o && ready_i};
        if (rst_i || clear_i) {in_q, out_q} <= 0;
    end
endmodule

`default_nettype wire
