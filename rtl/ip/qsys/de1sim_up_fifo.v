// de1sim_up_fifo.v - a FIFO of 2^LOG2 words: what is pushed while it is full is lost, and rdata_o
// is its first word, when it is empty the last that there was

`default_nettype none

module de1sim_up_fifo #(parameter WIDTH = 32, LOG2 = 7) (
    input  wire             clk_i,
    input  wire             rst_i,
    input  wire             push_i,
    input  wire [WIDTH-1:0] wdata_i,
    input  wire             pop_i,
    output wire [WIDTH-1:0] rdata_o,
    output reg  [LOG2:0]    count_o
);
    reg [WIDTH-1:0] words [0:(1 << LOG2) - 1];
    reg [LOG2-1:0]  first_q;
    reg [WIDTH-1:0] last_q;

    wire pushes = push_i && !count_o[LOG2];
    wire pops   = pop_i && count_o != 0;

    assign rdata_o = count_o == 0 ? last_q : words[first_q];

    always @(posedge clk_i) begin
        if (pushes) words[first_q + count_o[LOG2-1:0]] <= wdata_i;
        if (pops) begin
            first_q <= first_q + 1'b1;
            last_q  <= words[first_q];
        end
        count_o <= count_o + {{LOG2{1'b0}}, pushes} - {{LOG2{1'b0}}, pops};
        if (rst_i) count_o <= 0;
    end
endmodule

`default_nettype wire
