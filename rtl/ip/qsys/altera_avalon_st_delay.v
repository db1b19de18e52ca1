// altera_avalon_st_delay.v - Platform Designer's delay of a stream, by whole clocks
//
// Source: Platform Designer User Guide, Avalon Streaming Delay.

`default_nettype none

module altera_avalon_st_delay #(
    parameter NUMBER_OF_DELAY_CLOCKS = 1,
    parameter DATA_WIDTH    = 8,
    parameter EMPTY_WIDTH   = 1,
    parameter CHANNEL_WIDTH = 1,
    parameter ERROR_WIDTH   = 1
) (
    // verilator lint_off UNUSED
    input  wire                     clk,
    input  wire                     reset,
    // verilator lint_on UNUSED

    input  wire                     in0_valid,
    input  wire [DATA_WIDTH-1:0]    in0_data,
    input  wire                     in0_startofpacket,
    input  wire                     in0_endofpacket,
    input  wire [EMPTY_WIDTH-1:0]   in0_empty,
    input  wire [CHANNEL_WIDTH-1:0] in0_channel,
    input  wire [ERROR_WIDTH-1:0]   in0_error,

    output wire                     out0_valid,
    output wire [DATA_WIDTH-1:0]    out0_data,
    output wire                     out0_startofpacket,
    output wire                     out0_endofpacket,
    output wire [EMPTY_WIDTH-1:0]   out0_empty,
    output wire [CHANNEL_WIDTH-1:0] out0_channel,
    output wire [ERROR_WIDTH-1:0]   out0_error
);
    localparam WIDTH = 3 + DATA_WIDTH + EMPTY_WIDTH + CHANNEL_WIDTH + ERROR_WIDTH;

    wire [WIDTH-1:0] in = {in0_valid, in0_data, in0_startofpacket, in0_endofpacket, in0_empty,
                           in0_channel, in0_error};
    wire [WIDTH-1:0] out;
    assign {out0_valid, out0_data, out0_startofpacket, out0_endofpacket, out0_empty, out0_channel,
            out0_error} = out;

    generate
        if (NUMBER_OF_DELAY_CLOCKS == 0) begin : none
            assign out = in;
        end else begin : clocks
            localparam ALL = NUMBER_OF_DELAY_CLOCKS * WIDTH;
            reg  [ALL-1:0]       line_q;
            wire [ALL+WIDTH-1:0] line = {line_q, in};
            assign out = line_q[ALL-1 -: WIDTH];
            always @(posedge clk) line_q <= reset ? {ALL{1'b0}} : line[ALL-1:0];
        end
    endgenerate
endmodule

`default_nettype wire
