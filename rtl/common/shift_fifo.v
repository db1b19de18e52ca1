// shift_fifo.v - first-word fall-through FIFO of registers, no memory: for a few bits
//
// The oldest word lies at the bottom, and a pop shifts all words down.  rdata_o is the oldest word
// while count_o > 0, from the clock after its push.  A push when full is dropped, even together
// with a pop.  A pop when empty does nothing.

`default_nettype none

module shift_fifo #(
    parameter WIDTH      = 5,
    parameter DEPTH_LOG2 = 4
) (
    input  wire                clk_i,
    input  wire                rst_i,

    input  wire                push_i,
    input  wire [WIDTH-1:0]    wdata_i,
    input  wire                pop_i,
    output wire [WIDTH-1:0]    rdata_o,

    output reg  [DEPTH_LOG2:0] count_o
);
    localparam DEPTH = 1 << DEPTH_LOG2;
    localparam [DEPTH_LOG2:0] ONE = 1;

    reg [DEPTH * WIDTH - 1:0] words_q;

    assign rdata_o = words_q[WIDTH-1:0];

    wire                pop  = pop_i && count_o != 0;
    wire [DEPTH_LOG2:0] left = pop ? count_o - ONE : count_o;   // after a pop

    integer n;
    always @(posedge clk_i) begin
        if (pop) words_q <= words_q >> WIDTH;
        if (push_i && !count_o[DEPTH_LOG2]) begin
            for (n = 0; n < DEPTH; n = n + 1)
                if (left == n[DEPTH_LOG2:0]) words_q[n * WIDTH +: WIDTH] <= wdata_i;
            count_o <= left + ONE;
        end else begin
            count_o <= left;
        end
        if (rst_i) count_o <= 0;
    end
endmodule

`default_nettype wire
