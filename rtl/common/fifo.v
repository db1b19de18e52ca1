// fifo.v - synchronous first-word fall-through FIFO of 2^DEPTH_LOG2 words
//
//   wdata_i --+--> memory --> memory_q --+
//             |                          +--> rdata_o
//             +--> passed_q -------------+    (a word that is the oldest at once)
//
// rdata_o is the oldest word while !empty_o, from the clock after its push; when the last word has
// been popped it stays that word until the next push.  A push when full is dropped, even together
// with a pop.  A pop when empty does nothing.  clear_i empties the FIFO and has priority over a
// push.  The memory is never read at the address that is written in the same clock.

`default_nettype none

module fifo #(
    parameter WIDTH      = 32,
    parameter DEPTH_LOG2 = 7
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
    output wire                empty_o,
    output wire                awake_o   // clear_i has not taken effect yet
);
    localparam [DEPTH_LOG2:0] ONE = 1;

    reg [WIDTH-1:0]      memory [0:(1 << DEPTH_LOG2) - 1];
    reg [WIDTH-1:0]      memory_q, passed_q;
    reg [DEPTH_LOG2-1:0] write_q, read_q;        // where the next word goes, where the oldest lies
    reg                  head_passed_q;

    function [DEPTH_LOG2-1:0] after;
        input [DEPTH_LOG2-1:0] place;
        after = place + ONE[DEPTH_LOG2-1:0];
    endfunction

    assign full_o  = count_o[DEPTH_LOG2];
    assign empty_o = count_o == {(DEPTH_LOG2 + 1){1'b0}};
    assign rdata_o = head_passed_q ? passed_q : memory_q;
    assign awake_o = clear_i && {count_o, write_q, read_q} != {(3 * DEPTH_LOG2 + 1){1'b0}};

    wire push = push_i && !full_o;
    wire pop  = pop_i && !empty_o;

    // Reads come before writes, so that a simulator needs no copies of what both touch.
    always @(posedge clk_i) begin
        if (pop) begin
            if (count_o != ONE) memory_q <= memory[after(read_q)];
            read_q <= after(read_q);
        end
        if (push) begin
            memory[write_q] <= wdata_i;
            write_q         <= after(write_q);
        end
        if (push_i && (empty_o || (pop_i && count_o == ONE))) begin
            passed_q      <= wdata_i;
            head_passed_q <= 1'b1;
        end else if (pop && count_o != ONE) begin
            head_passed_q <= 1'b0;
        end
        count_o <= push == pop ? count_o : push ? count_o + ONE : count_o - ONE;
        if (clear_i || rst_i) begin
            count_o <= {(DEPTH_LOG2 + 1){1'b0}};
            write_q <= {DEPTH_LOG2{1'b0}};
            read_q  <= {DEPTH_LOG2{1'b0}};
        end
    end
endmodule

`default_nettype wire
