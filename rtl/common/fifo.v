// fifo.v - synchronous first-word fall-through FIFO of 2^DEPTH_LOG2 words
//
//   wdata_i --+--> memory --> memory_q --+
//             |                          +--> rdata_o
//             +--> passed_q -------------+    (a word that is the head at once)
//
// rdata_o is the oldest word while !empty_o, from the clock after its push.  A push when full is
// dropped, even beside a pop; a pop when empty does nothing; clear_i empties and beats a push.
// The memory is never read at the address that is written in the same clock.  It is a memory for
// each SLICE bits: so narrow that a block RAM would stand nearly empty, it becomes look-up tables.

`default_nettype none

module fifo #(
    parameter WIDTH      = 32,
    parameter DEPTH_LOG2 = 7,
    parameter SLICE      = WIDTH    // a divisor of WIDTH
) (
    input  wire                clk_i,
    input  wire                rst_i,

    input  wire                clear_i,
    input  wire                push_i,
    input  wire [WIDTH-1:0]    wdata_i,
    input  wire                pop_i,
    output wire [WIDTH-1:0]    rdata_o,

    output reg  [DEPTH_LOG2:0] count_o,
    output wire                full_o,
    output wire                empty_o
);
    localparam [DEPTH_LOG2:0] ONE = 1;

    // ---- Fill -------------------------------------------------------------
    wire push = push_i && !full_o;
    wire pop  = pop_i && !empty_o;

    assign full_o  = count_o[DEPTH_LOG2];
    assign empty_o = count_o == {(DEPTH_LOG2 + 1){1'b0}};

    always @(posedge clk_i) begin
        if (push && !pop) count_o <= count_o + ONE;
        if (pop && !push) count_o <= count_o - ONE;
        if (rst_i || clear_i) count_o <= {(DEPTH_LOG2 + 1){1'b0}};
    end

    // ---- Words ------------------------------------------------------------
    wire [WIDTH-1:0]     memory_q;
    reg [WIDTH-1:0]      passed_q;
    reg [DEPTH_LOG2-1:0] write_q, read_q;        // where the next word goes, where the head lies
    reg                  head_passed_q;

    wire [DEPTH_LOG2-1:0] next_read = read_q + ONE[DEPTH_LOG2-1:0];
    wire                  pass      = push && (pop ? count_o == ONE : empty_o);

    assign rdata_o = head_passed_q ? passed_q : memory_q;

    genvar n;
    generate for (n = 0; n < WIDTH; n = n + SLICE) begin : slice
        reg [SLICE-1:0] memory [0:(1 << DEPTH_LOG2) - 1];
        reg [SLICE-1:0] word_q;
        assign memory_q[n +: SLICE] = word_q;

        always @(posedge clk_i) begin
            if (push) memory[write_q] <= wdata_i[n +: SLICE];
            if (pop && !pass) word_q <= memory[next_read];
        end
    end endgenerate

    always @(posedge clk_i) begin
        if (push) write_q <= write_q + ONE[DEPTH_LOG2-1:0];
        if (pop) begin
            read_q        <= next_read;
            head_passed_q <= 1'b0;
        end
        if (pass) begin
            passed_q      <= wdata_i;
            head_passed_q <= 1'b1;
        end
        if (rst_i || clear_i) begin
            write_q <= {DEPTH_LOG2{1'b0}};
            read_q  <= {DEPTH_LOG2{1'b0}};
        end
    end
endmodule

`default_nettype wire
