// small_fifo.v - first-word fall-through FIFO that reads its memory at once: for a few words
//
// rdata_o is the oldest word while !empty_o, from the clock after its push.  A push when full is
// dropped, even beside a pop; a pop when empty does nothing.

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

    output wire [DEPTH_LOG2:0] count_o
);
    localparam [DEPTH_LOG2:0] ONE = 1, FULL = 1 << DEPTH_LOG2;

    reg [WIDTH-1:0]    memory [0:(1 << DEPTH_LOG2) - 1];
    reg [DEPTH_LOG2:0] write_q, read_q;   // a bit more than an address: full is not empty

    assign count_o = write_q - read_q;
    assign rdata_o = memory[read_q[DEPTH_LOG2-1:0]];

    always @(posedge clk_i) begin
        if (push_i && count_o != FULL) begin
            memory[write_q[DEPTH_LOG2-1:0]] <= wdata_i;
            write_q <= write_q + ONE;
        end
        if (pop_i && write_q != read_q) read_q <= read_q + ONE;
        if (rst_i) begin
            write_q <= {(DEPTH_LOG2 + 1){1'b0}};
            read_q  <= {(DEPTH_LOG2 + 1){1'b0}};
        end
    end
endmodule

`default_nettype wire
