// dual_clock_fifo.v - first-word fall-through FIFO between two clocks, 2^DEPTH_LOG2 words
//
//   push --> words, write_q --> Gray code --> two flip-flops of rclk_i --> empty_o
//   full_o <-- two flip-flops of wclk_i <-- Gray code <-- read_q <-- pop
//
// A pointer in Gray code changes one bit at a time, so the other side samples the old value or the
// new one, never a third.  It sees a push or a pop two of its clocks later; until then it takes the
// FIFO for emptier (reader) or fuller (writer) than it is.  A push when full is dropped; a pop when
// empty does nothing.  Words lie in registers, so keep the FIFO small.
//
// Each reset lasts until the other side has been reset, and two clocks more.

`default_nettype none

module dual_clock_fifo #(
    parameter WIDTH      = 48,
    parameter DEPTH_LOG2 = 1
) (
    input  wire             wclk_i,
    input  wire             wrst_i,
    input  wire             push_i,
    input  wire [WIDTH-1:0] wdata_i,
    output wire             full_o,
    output wire             wawake_o,   // a pop has not been seen here yet

    input  wire             rclk_i,
    input  wire             rrst_i,
    input  wire             pop_i,
    output reg  [WIDTH-1:0] rdata_o,    // the oldest word while !empty_o
    output wire             empty_o,
    output wire             rawake_o    // a push has not been seen here yet
);
    localparam DEPTH = 1 << DEPTH_LOG2;
    localparam [DEPTH_LOG2:0] ONE = 1;
    localparam [DEPTH_LOG2:0] FULL = 3 << (DEPTH_LOG2 - 1);   // XOR of the codes when full

    function [DEPTH_LOG2:0] gray;
        input [DEPTH_LOG2:0] count;
        gray = count ^ (count >> 1);
    endfunction

    // ---- Write side: write_q counts the words pushed, modulo twice the depth ---------
    reg  [DEPTH * WIDTH - 1:0] words_q;
    reg  [DEPTH_LOG2:0] write_q, write_gray_q, read_q, read_gray_q;
    wire [DEPTH_LOG2:0] read_seen, write_seen;
    wire                read_coming, write_coming;

    sync #(.WIDTH(DEPTH_LOG2 + 1)) read_sync (
        .clk_i(wclk_i), .async_i(read_gray_q), .sync_o(read_seen), .awake_o(read_coming)
    );

    assign full_o   = (write_gray_q ^ read_seen) == FULL;
    assign wawake_o = read_coming || read_gray_q != read_seen;

    integer n;
    always @(posedge wclk_i) begin
        if (push_i && !full_o) begin
            for (n = 0; n < DEPTH; n = n + 1)
                if (write_q[DEPTH_LOG2-1:0] == n[DEPTH_LOG2-1:0])
                    words_q[n * WIDTH +: WIDTH] <= wdata_i;
            write_q      <= write_q + ONE;
            write_gray_q <= gray(write_q + ONE);
        end
        if (wrst_i) begin
            write_q      <= 0;
            write_gray_q <= 0;
        end
    end

    // ---- Read side ----------------------------------------------------------------------------
    sync #(.WIDTH(DEPTH_LOG2 + 1)) write_sync (
        .clk_i(rclk_i), .async_i(write_gray_q), .sync_o(write_seen), .awake_o(write_coming)
    );

    assign empty_o  = read_gray_q == write_seen;
    assign rawake_o = write_coming || write_gray_q != write_seen;

    integer m;
    always @* begin
        rdata_o = words_q[WIDTH-1:0];
        for (m = 1; m < DEPTH; m = m + 1)
            if (read_q[DEPTH_LOG2-1:0] == m[DEPTH_LOG2-1:0]) rdata_o = words_q[m * WIDTH +: WIDTH];
    end

    always @(posedge rclk_i) begin
        if (pop_i && !empty_o) begin
            read_q      <= read_q + ONE;
            read_gray_q <= gray(read_q + ONE);
        end
        if (rrst_i) begin
            read_q      <= 0;
            read_gray_q <= 0;
        end
    end
endmodule

`default_nettype wire
