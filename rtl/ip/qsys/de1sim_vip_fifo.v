// de1sim_vip_fifo.v - a FIFO between two clocks, with pointers in Gray code

`default_nettype none

module de1sim_vip_fifo #(
    parameter WIDTH = 32,
    parameter LOG2  = 6  // of its words
) (
    input  wire             in_clk_i,
    input  wire             in_rst_i,
    input  wire             write_i,
    input  wire [WIDTH-1:0] data_i,
    output wire [LOG2:0]    in_used_o,   // words, as the writer sees them

    input  wire             out_clk_i,
    input  wire             out_rst_i,
    input  wire             read_i,
    output wire [WIDTH-1:0] data_o,      // the first word
    output wire [LOG2:0]    out_used_o   // words, as the reader sees them
);
    function [LOG2:0] binary;
        input [LOG2:0] gray;
        integer n;
        begin
            binary = gray;
            for (n = 1; n <= LOG2; n = n + 1) binary = binary ^ (gray >> n);
        end
    endfunction

    reg [WIDTH-1:0] words [0:(1 << LOG2) - 1];
    reg [LOG2:0]    in_q = 0, out_q = 0, in_gray_q = 0, out_gray_q = 0;
    reg [LOG2:0]    in_seen_q = 0, in_sync_q = 0, out_seen_q = 0, out_sync_q = 0;

    wire [LOG2:0]   in_next = in_q + 1'b1, out_next = out_q + 1'b1;

    assign in_used_o  = in_q - binary(out_seen_q);
    assign out_used_o = binary(in_seen_q) - out_q;
    assign data_o     = words[out_q[LOG2-1:0]];

    always @(posedge in_clk_i) begin
        {out_seen_q, out_sync_q} <= {out_sync_q, out_gray_q};
        if (write_i) begin
            words[in_q[LOG2-1:0]] <= data_i;
            in_q      <= in_next;
            in_gray_q <= in_next ^ (in_next >> 1);
        end
        if (in_rst_i) {in_q, in_gray_q, out_seen_q, out_sync_q} <= 0;
    end

    always @(posedge out_clk_i) begin
        {in_seen_q, in_sync_q} <= {in_sync_q, in_gray_q};
        if (read_i) begin
            out_q      <= out_next;
            out_gray_q <= out_next ^ (out_next >> 1);
        end
        if (out_rst_i) {out_q, out_gray_q, in_seen_q, in_sync_q} <= 0;
    end
endmodule

`default_nettype wire
