// altera_up_avalon_video_change_alpha.v - the University Program's filter that gives all pixels of
// one colour another alpha

`default_nettype none

module altera_up_avalon_video_change_alpha #(
    parameter BITS  = 40,          // alpha is the upper quarter
    parameter COLOR = 0,
    parameter ALPHA = 0
) (
    // verilator lint_off UNUSED
    input  wire            clk,
    input  wire            reset,
    // verilator lint_on UNUSED
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
    localparam PART = BITS / 4;

    wire [3*PART-1:0] color = stream_in_data[3*PART-1:0];

    assign stream_out_data = {color == COLOR[3*PART-1:0] ? ALPHA[PART-1:0]
                                                         : stream_in_data[BITS-1:3*PART], color};
    assign stream_out_startofpacket = stream_in_startofpacket;
    assign stream_out_endofpacket   = stream_in_endofpacket;
    assign stream_out_valid         = stream_in_valid;
    assign stream_in_ready          = stream_out_ready;
endmodule

`default_nettype wire
