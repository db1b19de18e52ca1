// de1sim_up_fifo.v - a FIFO of 128 words: what is pushed while it is full is lost, and rdata_o is
// its first word, when it is empty the last that there was

`default_nettype none

module de1sim_up_fifo #(parameter WIDTH = 32) (
    input  wire             clk_i,
    input  wire             rst_i,
    input  wire             push_i,
    input  wire [WIDTH-1:0] wdata_i,
    input  wire             pop_i,
    output wire [WIDTH-1:0] rdata_o,
    output reg  [7:0]       count_o
);
    localparam [7:0] DEPTH = 8'd128;

    reg [WIDTH-1:0] words [0:127];
    reg [6:0]       first_q;
    reg [WIDTH-1:0] last_q;

    wire pushes = push_i && count_o != DEPTH;
    wire pops   = pop_i && count_o != 8'd0;

    assign rdata_o = count_o == 8'd0 ? last_q : words[first_q];

    always @(posedge clk_i) begin
        if (pushes) words[first_q + count_o[6:0]] <= wdata_i;
        if (pops) begin
            first_q <= first_q + 7'd1;
            last_q  <= words[first_q];
        end
        count_o <= count_o + {7'd0, pushes} - {7'd0, pops};
        if (rst_i) count_o <= 8'd0;
    end
endmodule

`default_nettype wire
