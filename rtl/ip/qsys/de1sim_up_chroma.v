// de1sim_up_chroma.v - the University Program's chroma resampler
//
// A format is its bits: 24 Cr Cb Y, of each pixel; 16 Cb Y and Cr Y in turn, beginning with a
// packet; 8 Y alone.  From 16, the part that a pixel has not is that of the pixel before, and 0 for
// the first one's Cr; from 8 both are 128, grey.

`default_nettype none

module de1sim_up_chroma #(parameter IN = 16, OUT = 24) (
    // verilator lint_off UNUSED
    input  wire           clk,
    input  wire           reset,
    input  wire [IN-1:0]  stream_in_data,
    input  wire           stream_in_startofpacket,
    input  wire           stream_in_endofpacket,
    input  wire           stream_in_valid,
    output wire           stream_in_ready,
    output wire [OUT-1:0] stream_out_data,
    output wire           stream_out_startofpacket,
    output wire           stream_out_endofpacket,
    output wire           stream_out_valid,
    input  wire           stream_out_ready
    // verilator lint_on UNUSED
);
    // ---- What is in the pixel ---------------------------------------------
    reg        odd_q;             // of a packet's pixels
    reg  [7:0] before_q;          // the other part of chroma
    wire       odd    = odd_q && !stream_in_startofpacket;
    wire [7:0] other = stream_in_startofpacket ? 8'd0 : before_q;
    wire [23:0] in = {{(24 - IN){1'b0}}, stream_in_data};
    wire [23:0] all = IN == 24 ? in
                    : IN == 16 ? {odd ? {in[15:8], other} : {other, in[15:8]}, in[7:0]}
                    : {16'h8080, in[7:0]};

    always @(posedge clk) begin
        if (stream_in_valid && stream_in_ready) begin
            odd_q    <= !odd;
            before_q <= in[15:8];
        end
        if (reset) odd_q <= 1'b0;
    end

    // ---- What is wanted ---------------------------------------------------
    wire [23:0] out = OUT == 16 ? {8'd0, odd ? all[23:16] : all[15:8], all[7:0]} : all;

    assign stream_out_data          = out[OUT-1:0];
    assign stream_out_startofpacket = stream_in_startofpacket;
    assign stream_out_endofpacket   = stream_in_endofpacket;
    assign stream_out_valid         = stream_in_valid;
    assign stream_in_ready          = stream_out_ready;
endmodule

`default_nettype wire
