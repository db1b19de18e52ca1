// de1sim_up_crossing.v - the University Program's dual clock buffer: a stream from one clock to
// another, by a FIFO of 128 with pointers in Gray code

`default_nettype none

module de1sim_up_crossing #(parameter BITS = 30) (
    input  wire            clk_stream_in,
    input  wire            reset_stream_in,
    input  wire            clk_stream_out,
    input  wire            reset_stream_out,
    input  wire [BITS-1:0] stream_in_data,
    input  wire            stream_in_startofpacket,
    input  wire            stream_in_endofpacket,
    input  wire            stream_in_valid,
    output wire            stream_in_ready,
    output wire [BITS-1:0] stream_out_data,
    output wire            stream_out_startofpacket,
    output wire            stream_out_endofpacket,
    output wire            stream_out_valid,
    input  wire            stream_out_ready
);
    function [7:0] gray;
        input [7:0] n;
        gray = n ^ (n >> 1);
    endfunction

    reg [BITS+1:0] words [0:127];
    reg [7:0]      in_q, out_q, in_gray_q, out_gray_q;
    reg [15:0]     in_seen_q, out_seen_q;    // two registers each: in the other clock

    wire [7:0] full = {~out_seen_q[15:14], out_seen_q[13:8]};

    assign stream_in_ready  = in_gray_q != full;
    assign stream_out_valid = out_gray_q != in_seen_q[15:8];
    assign {stream_out_startofpacket, stream_out_endofpacket, stream_out_data} = words[out_q[6:0]];

    always @(posedge clk_stream_in) begin
        out_seen_q <= {out_seen_q[7:0], out_gray_q};
        if (stream_in_valid && stream_in_ready) begin
            words[in_q[6:0]] <= {stream_in_startofpacket, stream_in_endofpacket, stream_in_data};
            in_q      <= in_q + 8'd1;
            in_gray_q <= gray(in_q + 8'd1);
        end
        if (reset_stream_in) begin
            {in_q, in_gray_q} <= 16'd0;
            out_seen_q        <= 16'd0;
        end
    end
    always @(posedge clk_stream_out) begin
        in_seen_q <= {in_seen_q[7:0], in_gray_q};
        if (stream_out_valid && stream_out_ready) begin
            out_q      <= out_q + 8'd1;
            out_gray_q <= gray(out_q + 8'd1);
        end
        if (reset_stream_out) begin
            {out_q, out_gray_q} <= 16'd0;
            in_seen_q           <= 16'd0;
        end
    end
endmodule

`default_nettype wire
