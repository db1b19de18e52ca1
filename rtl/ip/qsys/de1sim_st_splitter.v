// de1sim_st_splitter.v - Platform Designer's splitter and demultiplexer of streams
//
// They have one source and up to 16 sinks.  The splitter gives a word to all when all are ready;
// without QUALIFIED the sinks have to wait for that themselves.  The demultiplexer gives it to the
// one whose number the channel has; one of nobody is dropped.
//
// Source: Platform Designer User Guide, Avalon Streaming Splitter, Demultiplexer.

`default_nettype none

module de1sim_st_splitter #(
    parameter COUNT   = 2,
    parameter DATA    = 8,
    parameter EMPTY   = 1,
    parameter CHANNEL = 1,   // bits of the common side's channel
    parameter OWN     = 1,   // bits of the others'
    parameter ERROR   = 1,
    parameter SELECT  = 1,   // bits of the common channel that are a number of the others
    parameter HIGH    = 1,   // these are its upper bits
    parameter QUALIFIED     = 1,
    parameter DEMULTIPLEXES = 0,
    parameter READY   = 1    // 0 = the sinks have no ready
) (
    // verilator lint_off UNUSED
    input  wire               clk,
    input  wire               reset,
    input  wire               reset_n,

    output wire out0_valid, input  wire out0_ready, output wire [DATA-1:0] out0_data,
    output wire out0_startofpacket, out0_endofpacket, output wire [EMPTY-1:0] out0_empty,
    output wire [OWN-1:0] out0_channel, output wire [ERROR-1:0] out0_error,
    output wire out1_valid, input  wire out1_ready, output wire [DATA-1:0] out1_data,
    output wire out1_startofpacket, out1_endofpacket, output wire [EMPTY-1:0] out1_empty,
    output wire [OWN-1:0] out1_channel, output wire [ERROR-1:0] out1_error,
    output wire out2_valid, input  wire out2_ready, output wire [DATA-1:0] out2_data,
    output wire out2_startofpacket, out2_endofpacket, output wire [EMPTY-1:0] out2_empty,
    output wire [OWN-1:0] out2_channel, output wire [ERROR-1:0] out2_error,
    output wire out3_valid, input  wire out3_ready, output wire [DATA-1:0] out3_data,
    output wire out3_startofpacket, out3_endofpacket, output wire [EMPTY-1:0] out3_empty,
    output wire [OWN-1:0] out3_channel, output wire [ERROR-1:0] out3_error,
    output wire out4_valid, input  wire out4_ready, output wire [DATA-1:0] out4_data,
    output wire out4_startofpacket, out4_endofpacket, output wire [EMPTY-1:0] out4_empty,
    output wire [OWN-1:0] out4_channel, output wire [ERROR-1:0] out4_error,
    output wire out5_valid, input  wire out5_ready, output wire [DATA-1:0] out5_data,
    output wire out5_startofpacket, out5_endofpacket, output wire [EMPTY-1:0] out5_empty,
    output wire [OWN-1:0] out5_channel, output wire [ERROR-1:0] out5_error,
    output wire out6_valid, input  wire out6_ready, output wire [DATA-1:0] out6_data,
    output wire out6_startofpacket, out6_endofpacket, output wire [EMPTY-1:0] out6_empty,
    output wire [OWN-1:0] out6_channel, output wire [ERROR-1:0] out6_error,
    output wire out7_valid, input  wire out7_ready, output wire [DATA-1:0] out7_data,
    output wire out7_startofpacket, out7_endofpacket, output wire [EMPTY-1:0] out7_empty,
    output wire [OWN-1:0] out7_channel, output wire [ERROR-1:0] out7_error,
    output wire out8_valid, input  wire out8_ready, output wire [DATA-1:0] out8_data,
    output wire out8_startofpacket, out8_endofpacket, output wire [EMPTY-1:0] out8_empty,
    output wire [OWN-1:0] out8_channel, output wire [ERROR-1:0] out8_error,
    output wire out9_valid, input  wire out9_ready, output wire [DATA-1:0] out9_data,
    output wire out9_startofpacket, out9_endofpacket, output wire [EMPTY-1:0] out9_empty,
    output wire [OWN-1:0] out9_channel, output wire [ERROR-1:0] out9_error,
    output wire out10_valid, input  wire out10_ready, output wire [DATA-1:0] out10_data,
    output wire out10_startofpacket, out10_endofpacket, output wire [EMPTY-1:0] out10_empty,
    output wire [OWN-1:0] out10_channel, output wire [ERROR-1:0] out10_error,
    output wire out11_valid, input  wire out11_ready, output wire [DATA-1:0] out11_data,
    output wire out11_startofpacket, out11_endofpacket, output wire [EMPTY-1:0] out11_empty,
    output wire [OWN-1:0] out11_channel, output wire [ERROR-1:0] out11_error,
    output wire out12_valid, input  wire out12_ready, output wire [DATA-1:0] out12_data,
    output wire out12_startofpacket, out12_endofpacket, output wire [EMPTY-1:0] out12_empty,
    output wire [OWN-1:0] out12_channel, output wire [ERROR-1:0] out12_error,
    output wire out13_valid, input  wire out13_ready, output wire [DATA-1:0] out13_data,
    output wire out13_startofpacket, out13_endofpacket, output wire [EMPTY-1:0] out13_empty,
    output wire [OWN-1:0] out13_channel, output wire [ERROR-1:0] out13_error,
    output wire out14_valid, input  wire out14_ready, output wire [DATA-1:0] out14_data,
    output wire out14_startofpacket, out14_endofpacket, output wire [EMPTY-1:0] out14_empty,
    output wire [OWN-1:0] out14_channel, output wire [ERROR-1:0] out14_error,
    output wire out15_valid, input  wire out15_ready, output wire [DATA-1:0] out15_data,
    output wire out15_startofpacket, out15_endofpacket, output wire [EMPTY-1:0] out15_empty,
    output wire [OWN-1:0] out15_channel, output wire [ERROR-1:0] out15_error,

    input  wire               in_valid,
    output wire               in_ready,
    input  wire [DATA-1:0]    in_data,
    input  wire               in_startofpacket,
    input  wire               in_endofpacket,
    input  wire [EMPTY-1:0]   in_empty,
    input  wire [CHANNEL-1:0] in_channel,
    input  wire [ERROR-1:0]   in_error
    // verilator lint_on UNUSED
);
    localparam WIDTH = 2 + EMPTY + ERROR + DATA;
    localparam [15:0] THERE = 16'hffff >> (16 - COUNT);

    wire [15:0]      has = {
        out15_ready, out14_ready, out13_ready, out12_ready, out11_ready,
        out10_ready, out9_ready, out8_ready, out7_ready, out6_ready,
        out5_ready, out4_ready, out3_ready, out2_ready, out1_ready,
        out0_ready};
    wire [15:0]      ready = (READY != 0 ? has : 16'hffff) | ~THERE;
    wire [WIDTH-1:0] word = {in_startofpacket, in_endofpacket, in_empty, in_error, in_data};
    wire [OWN-1:0]   own;
    wire [15:0]      goes;

    assign {out15_valid, out14_valid, out13_valid, out12_valid, out11_valid,
            out10_valid, out9_valid, out8_valid, out7_valid, out6_valid,
            out5_valid, out4_valid, out3_valid, out2_valid, out1_valid,
            out0_valid} = goes;
    assign {out0_startofpacket, out0_endofpacket, out0_empty, out0_error, out0_data} = word;
    assign out0_channel = own;
    assign {out1_startofpacket, out1_endofpacket, out1_empty, out1_error, out1_data} = word;
    assign out1_channel = own;
    assign {out2_startofpacket, out2_endofpacket, out2_empty, out2_error, out2_data} = word;
    assign out2_channel = own;
    assign {out3_startofpacket, out3_endofpacket, out3_empty, out3_error, out3_data} = word;
    assign out3_channel = own;
    assign {out4_startofpacket, out4_endofpacket, out4_empty, out4_error, out4_data} = word;
    assign out4_channel = own;
    assign {out5_startofpacket, out5_endofpacket, out5_empty, out5_error, out5_data} = word;
    assign out5_channel = own;
    assign {out6_startofpacket, out6_endofpacket, out6_empty, out6_error, out6_data} = word;
    assign out6_channel = own;
    assign {out7_startofpacket, out7_endofpacket, out7_empty, out7_error, out7_data} = word;
    assign out7_channel = own;
    assign {out8_startofpacket, out8_endofpacket, out8_empty, out8_error, out8_data} = word;
    assign out8_channel = own;
    assign {out9_startofpacket, out9_endofpacket, out9_empty, out9_error, out9_data} = word;
    assign out9_channel = own;
    assign {out10_startofpacket, out10_endofpacket, out10_empty, out10_error, out10_data} = word;
    assign out10_channel = own;
    assign {out11_startofpacket, out11_endofpacket, out11_empty, out11_error, out11_data} = word;
    assign out11_channel = own;
    assign {out12_startofpacket, out12_endofpacket, out12_empty, out12_error, out12_data} = word;
    assign out12_channel = own;
    assign {out13_startofpacket, out13_endofpacket, out13_empty, out13_error, out13_data} = word;
    assign out13_channel = own;
    assign {out14_startofpacket, out14_endofpacket, out14_empty, out14_error, out14_data} = word;
    assign out14_channel = own;
    assign {out15_startofpacket, out15_endofpacket, out15_empty, out15_error, out15_data} = word;
    assign out15_channel = own;

    generate
        if (DEMULTIPLEXES != 0) begin : one_of
            wire [SELECT-1:0] number;
            wire [15:0]       chosen = (16'd1 << number) & THERE;
            assign goes     = in_valid ? chosen : 16'd0;
            assign in_ready = (chosen & ~ready) == 16'd0;
            if (CHANNEL == SELECT) begin : alone
                assign number = in_channel;
                assign own    = {OWN{1'b0}};
            end else if (HIGH != 0) begin : high
                assign {number, own} = in_channel;
            end else begin : low
                assign {own, number} = in_channel;
            end
        end else begin : all
            genvar n;
            for (n = 0; n < 16; n = n + 1) begin : sink
                assign goes[n] = in_valid && (QUALIFIED == 0 || &(ready | 16'd1 << n));
            end
            assign in_ready = &ready;
            assign own      = in_channel;
        end
    endgenerate
endmodule

`default_nettype wire
