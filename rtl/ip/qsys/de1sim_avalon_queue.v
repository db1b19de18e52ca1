// de1sim_avalon_queue.v - a queue of 2^DEPTH_LOG2 words from one clock to another
//
// Each side counts its words, and sees the other's count in Gray code through two registers.

`default_nettype none

module de1sim_avalon_queue #(
    parameter WIDTH      = 32,
    parameter DEPTH_LOG2 = 4
) (
    input  wire             clk_i,
    input  wire             valid_i,
    output wire             ready_o,
    input  wire [WIDTH-1:0] data_i,

    input  wire             to_clk_i,
    output wire             valid_o,
    input  wire             ready_i,
    output wire [WIDTH-1:0] data_o
);
    localparam [DEPTH_LOG2:0] FULL = 3 << (DEPTH_LOG2 - 1);   // XOR of the codes when full

    reg [WIDTH-1:0] words_q [0:(1<<DEPTH_LOG2)-1];
    reg [DEPTH_LOG2:0] written_q = 0, read_q = 0;
    reg [DEPTH_LOG2:0] written_gray_q = 0, read_gray_q = 0;
    reg [DEPTH_LOG2:0] written_meta_q = 0, written_seen_q = 0;   // on to_clk_i
    reg [DEPTH_LOG2:0] read_meta_q = 0, read_seen_q = 0;         // on clk_i

    wire [DEPTH_LOG2:0] written = written_q + {{DEPTH_LOG2{1'b0}}, valid_i && ready_o};
    wire [DEPTH_LOG2:0] read    = read_q + {{DEPTH_LOG2{1'b0}}, valid_o && ready_i};

    assign ready_o = (written_gray_q ^ read_seen_q) != FULL;
    assign valid_o = read_gray_q != written_seen_q;
    assign data_o  = words_q[read_q[DEPTH_LOG2-1:0]];

    always @(posedge clk_i) begin
        if (valid_i && ready_o) words_q[written_q[DEPTH_LOG2-1:0]] <= data_i;
        written_q                  <= written;
        written_gray_q             <= written ^ written >> 1;
        {read_seen_q, read_meta_q} <= {read_meta_q, read_gray_q};
    end

    always @(posedge to_clk_i) begin
        read_q                           <= read;
        read_gray_q                      <= read ^ read >> 1;
        {written_seen_q, written_meta_q} <= {written_meta_q, written_gray_q};
    end
endmodule

`default_nettype wire
