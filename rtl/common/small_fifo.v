// small_fifo.v - first-word fall-through FIFO with an asynchronous read: for a few words
//
// rdata_o is the oldest word while !empty_o, from the clock after its push.  A push when full is
// dropped, even together with a pop.  A pop when empty does nothing.

`default_nettype none

module small_fifo #(
    parameter WIDTH      = 8,
    parameter DEPTH_LOG2 = 6
) (
    input  wire                clk_i,
    input  wire                rst_i,

    input  wire                push_i,
    input  wire [WIDTH-1:0]    wdata_i,
    input  wire                pop_i,
    output wire [WIDTH-1:0]    rdata_o,

    output reg  [DEPTH_LOG2:0] count_o
);
    localparam [DEPTH_LOG2:0] ONE = 1;

    reg [WIDTH-1:0]      memory [0:(1 << DEPTH_LOG2) - 1];
    reg [DEPTH_LOG2-1:0] write_q, read_q;

    assign rdata_o = memory[read_q];

    wire push = push_i && !count_o[DEPTH_LOG2];
    wire pop  = pop_i && count_o != 0;

    // Reads come before writes, so that a simulator needs no copies of what both touch.
    always @(posedge clk_i) begin
        if (push) begin
            memory[write_q] <= wdata_i;
            write_q         <= write_q + ONE[DEPTH_LOG2-1:0];
        end
        if (pop) read_q <= read_q + ONE[DEPTH_LOG2-1:0];
        count_o <= push == pop ? count_o : push ? count_o + ONE : count_o - ONE;
        if (rst_i) begin
            count_o <= 0;
            write_q <= 0;
            read_q  <= 0;
        end
    end
endmodule

`default_nettype wire
