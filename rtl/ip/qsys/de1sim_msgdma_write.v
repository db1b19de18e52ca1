// de1sim_msgdma_write.v - the write master of Platform Designer's mSGDMA: a stream to memory
//
//   stream -> FIFO -> words, with what the beat before has left -> writes
//
// A beat's first symbol, its highest, goes to the lowest address.  With UNALIGNED the first byte
// may go anywhere in a word, else the word's lower address bits are 0.  No more of the stream is
// taken than the command wants.  A command with end_on_eop ends with its packet; where `length`
// ends before, that is an early termination, and the rest of the packet is the next command's.

`default_nettype none

module de1sim_msgdma_write #(
    parameter WIDTH     = 32,
    parameter LENGTH    = 11,
    parameter FIFO_LOG2 = 5,
    parameter BURST     = 1,
    parameter WRAPS     = 0,
    parameter PROGRAMS  = 0,
    parameter STRIDES   = 0,
    parameter UNALIGNED = 0,
    parameter WHOLE     = 0,    // 1 = whole words alone
    parameter PACKETS   = 0,
    parameter BYTES     = WIDTH / 8
) (
    input  wire             clk_i,
    input  wire             clear_i,
    input  wire             rst_i,      // ends the command, when what is under way has come
    input  wire             pause_i,
    output wire             busy_o,
    output wire             writes_o,   // a write, or a burst, is under way

    input  wire             go_i,
    input  wire [31:0]      address_i,
    // verilator lint_off UNUSED
    input  wire [31:0]      length_i,
    // verilator lint_on UNUSED
    input  wire [7:0]       burst_i,
    input  wire [15:0]      stride_i,
    input  wire             end_on_eop_i,
    output wire             done_o,
    output wire [31:0]      written_o,  // bytes, with packets
    output reg  [7:0]       error_o,
    output wire             early_o,    // the packet is longer

    output reg  [31:0]      address_o,
    output reg              write_o,
    output reg  [WIDTH-1:0] writedata_o,
    output reg  [BYTES-1:0] byteenable_o,
    output reg  [10:0]      burstcount_o,
    input  wire             waitrequest_i,

    input  wire             valid_i,
    output wire             ready_o,
    input  wire [WIDTH-1:0] data_i,
    input  wire             eop_i,
    input  wire [6:0]       empty_i,
    input  wire [7:0]       error_i
);
    localparam LOW  = BYTES - 1;
    localparam [31:0] MASK = LOW, DEPTH = 1 << FIFO_LOG2;
    localparam [31:0] ALL = 32'hffffffff >> (32 - LENGTH);
    localparam ENTRY = 1 + 7 + 8 + WIDTH;

    // ---- The FIFO ----
    reg  [ENTRY-1:0]   entries_q [0:(1<<FIFO_LOG2)-1];
    reg  [FIFO_LOG2:0] in_q, out_q;
    reg  [31:0]        wanted_q;            // bytes of the stream
    reg                to_eop_q;
    wire [FIFO_LOG2:0] used = in_q - out_q;
    wire               takes = valid_i && ready_o;
    wire [WIDTH-1:0]   turned;
    wire               eop;
    wire [6:0]         empty;
    wire [7:0]         error;
    wire [WIDTH-1:0]   data;
    wire               pops, ends;   // ends: by rst_i
    genvar n;
    generate
        for (n = 0; n < WIDTH; n = n + 8) begin : symbol
            assign turned[n +: 8] = data_i[WIDTH-8-n +: 8];
        end
    endgenerate
    assign ready_o = {{31-FIFO_LOG2{1'b0}}, used} != DEPTH && wanted_q != 32'd0;
    assign {eop, empty, error, data} = entries_q[out_q[FIFO_LOG2-1:0]];
    always @(posedge clk_i) begin
        if (takes) entries_q[in_q[FIFO_LOG2-1:0]] <= {eop_i && PACKETS != 0,
            eop_i && PACKETS != 0 && WHOLE == 0 ? empty_i : 7'd0, error_i, turned};
        in_q  <= in_q + {{FIFO_LOG2{1'b0}}, takes};
        out_q <= out_q + {{FIFO_LOG2{1'b0}}, pops};
        if (takes)
            wanted_q <= (eop_i && to_eop_q) || wanted_q < BYTES ? 32'd0 : wanted_q - BYTES;
        if (go_i) wanted_q <= length;
        if (rst_i || clear_i) wanted_q <= 32'd0;
        if (ends || clear_i) {in_q, out_q} <= 0;
    end

    // ---- A command ----
    reg         busy_q, ended_q;           // ended_q: its packet has
    reg  [31:0] next_q, left_q, written_q; // bytes
    reg  [31:0] kept_q;                    // bytes that the beat before has left
    reg  [2*WIDTH-1:0] bytes_q;            // these
    reg  [10:0] burst_left_q;              // words of this burst that are to be offered
    reg  [7:0]  burst_q;
    reg  [15:0] stride_q;

    wire [31:0] length = length_i & ALL;
    wire [31:0] offset = next_q & MASK;
    wire [31:0] space  = BYTES - offset;
    wire [31:0] want   = left_q < space ? left_q : space;
    wire        enough = kept_q >= want || (ended_q && kept_q != 32'd0);
    wire [31:0] comes  = enough ? 32'd0 : BYTES - {25'd0, empty};
    wire [31:0] have   = kept_q + comes;
    wire [31:0] bytes  = have < want ? have : want;
    wire [2*WIDTH-1:0] joined = bytes_q | (enough ? {2*WIDTH{1'b0}}
                                                  : {{WIDTH{1'b0}}, data} << kept_q * 8);
    wire [31:0] most   = PROGRAMS != 0 && burst_q != 8'd0 && {24'd0, burst_q} < BURST
                         ? {24'd0, burst_q} : BURST;
    wire [31:0] words  = (offset + left_q + MASK) / BYTES;
    wire [31:0] aligned = to_eop_q || (WRAPS != 0 && (next_q & (BURST * BYTES - 1)) != 32'd0)
                          ? 32'd1 : words < most ? words : most;
    wire [31:0] beats  = left_q <= kept_q ? 32'd0 : (left_q - kept_q + MASK) / BYTES;
    wire [31:0] needs  = beats < aligned ? beats : aligned;
    wire        begins = burst_left_q == 11'd0;
    wire        has    = begins ? {{31-FIFO_LOG2{1'b0}}, used} >= (enough ? 32'd0 : needs)
                                : enough || used != 0;
    wire        over   = left_q == 32'd0 || (ended_q && kept_q == 32'd0);
    wire        free   = !write_o || !waitrequest_i;
    // A burst that has begun is ended.
    wire        offers = busy_q && !over && free && has && !(begins && (pause_i || rst_i));
    wire [BYTES-1:0] ones = {BYTES{1'b1}} >> BYTES - bytes;

    assign pops      = offers && !enough;
    assign busy_o    = busy_q;
    assign writes_o  = write_o || !begins;
    assign done_o    = busy_q && over && free;
    assign written_o = PACKETS != 0 ? written_q : 32'd0;
    assign early_o   = to_eop_q && left_q == 32'd0 && !(ended_q && kept_q == 32'd0);
    assign ends      = rst_i && begins && free;

    always @(posedge clk_i) begin
        if (free) write_o <= 1'b0;
        if (offers) begin
            write_o      <= 1'b1;
            writedata_o  <= joined[WIDTH-1:0] << offset * 8;
            byteenable_o <= WHOLE != 0 ? {BYTES{1'b1}} : ones << offset;
            if (begins) begin
                address_o    <= next_q & ~MASK;
                burstcount_o <= aligned[10:0];
                burst_left_q <= aligned[10:0] - 11'd1;
            end else
                burst_left_q <= burst_left_q - 11'd1;
            bytes_q   <= joined >> bytes * 8;
            kept_q    <= have - bytes;
            left_q    <= left_q - bytes;
            written_q <= written_q + bytes;
            next_q    <= next_q + (STRIDES != 0 && stride_q != 16'd1 ? BYTES * {16'd0, stride_q}
                                                                      : bytes);
            if (pops) begin
                error_o <= error_o | error;
                if (eop && to_eop_q) ended_q <= 1'b1;
            end
        end
        if (done_o) busy_q <= 1'b0;
        if (go_i) begin
            busy_q    <= 1'b1;
            next_q    <= UNALIGNED != 0 ? address_i : address_i & ~MASK;
            left_q    <= length;
            written_q <= 32'd0;
            kept_q    <= 32'd0;
            bytes_q   <= {2*WIDTH{1'b0}};
            burst_q   <= burst_i;
            stride_q  <= stride_i;
            to_eop_q  <= end_on_eop_i && PACKETS != 0;
            error_o   <= 8'd0;
            ended_q   <= 1'b0;
        end
        if (ends) busy_q <= 1'b0;
        if (clear_i) begin
            {busy_q, write_o} <= 2'b00;
            burst_left_q <= 11'd0;
        end
    end
endmodule

`default_nettype wire
