// de1sim_st_multiplexer.v - Platform Designer's multiplexer of streams: up to 16 sources, one sink
//
// The sources take turns, each for SIZE words, or a packet with BY_PACKETS, or until it has none.
// The channel that goes out has the source's number.
//
// Source: Platform Designer User Guide, Avalon Streaming Multiplexer.

`default_nettype none

module de1sim_st_multiplexer #(
    parameter COUNT   = 2,
    parameter DATA    = 8,
    parameter EMPTY   = 1,
    parameter CHANNEL = 1,   // bits of the common side's channel
    parameter OWN     = 1,   // bits of the others'
    parameter ERROR   = 1,
    parameter SELECT  = 1,   // bits of the common channel that are a number of the others
    parameter HIGH    = 1,   // these are its upper bits
    parameter SIZE    = 2,
    parameter BY_PACKETS = 0
) (
    input  wire               clk,
    input  wire               reset_n,

    // verilator lint_off UNUSED
    input  wire in0_valid, output wire in0_ready, input  wire [DATA-1:0] in0_data,
    input  wire in0_startofpacket, in0_endofpacket, input  wire [EMPTY-1:0] in0_empty,
    input  wire [OWN-1:0] in0_channel, input  wire [ERROR-1:0] in0_error,
    input  wire in1_valid, output wire in1_ready, input  wire [DATA-1:0] in1_data,
    input  wire in1_startofpacket, in1_endofpacket, input  wire [EMPTY-1:0] in1_empty,
    input  wire [OWN-1:0] in1_channel, input  wire [ERROR-1:0] in1_error,
    input  wire in2_valid, output wire in2_ready, input  wire [DATA-1:0] in2_data,
    input  wire in2_startofpacket, in2_endofpacket, input  wire [EMPTY-1:0] in2_empty,
    input  wire [OWN-1:0] in2_channel, input  wire [ERROR-1:0] in2_error,
    input  wire in3_valid, output wire in3_ready, input  wire [DATA-1:0] in3_data,
    input  wire in3_startofpacket, in3_endofpacket, input  wire [EMPTY-1:0] in3_empty,
    input  wire [OWN-1:0] in3_channel, input  wire [ERROR-1:0] in3_error,
    input  wire in4_valid, output wire in4_ready, input  wire [DATA-1:0] in4_data,
    input  wire in4_startofpacket, in4_endofpacket, input  wire [EMPTY-1:0] in4_empty,
    input  wire [OWN-1:0] in4_channel, input  wire [ERROR-1:0] in4_error,
    input  wire in5_valid, output wire in5_ready, input  wire [DATA-1:0] in5_data,
    input  wire in5_startofpacket, in5_endofpacket, input  wire [EMPTY-1:0] in5_empty,
    input  wire [OWN-1:0] in5_channel, input  wire [ERROR-1:0] in5_error,
    input  wire in6_valid, output wire in6_ready, input  wire [DATA-1:0] in6_data,
    input  wire in6_startofpacket, in6_endofpacket, input  wire [EMPTY-1:0] in6_empty,
    input  wire [OWN-1:0] in6_channel, input  wire [ERROR-1:0] in6_error,
    input  wire in7_valid, output wire in7_ready, input  wire [DATA-1:0] in7_data,
    input  wire in7_startofpacket, in7_endofpacket, input  wire [EMPTY-1:0] in7_empty,
    input  wire [OWN-1:0] in7_channel, input  wire [ERROR-1:0] in7_error,
    input  wire in8_valid, output wire in8_ready, input  wire [DATA-1:0] in8_data,
    input  wire in8_startofpacket, in8_endofpacket, input  wire [EMPTY-1:0] in8_empty,
    input  wire [OWN-1:0] in8_channel, input  wire [ERROR-1:0] in8_error,
    input  wire in9_valid, output wire in9_ready, input  wire [DATA-1:0] in9_data,
    input  wire in9_startofpacket, in9_endofpacket, input  wire [EMPTY-1:0] in9_empty,
    input  wire [OWN-1:0] in9_channel, input  wire [ERROR-1:0] in9_error,
    input  wire in10_valid, output wire in10_ready, input  wire [DATA-1:0] in10_data,
    input  wire in10_startofpacket, in10_endofpacket, input  wire [EMPTY-1:0] in10_empty,
    input  wire [OWN-1:0] in10_channel, input  wire [ERROR-1:0] in10_error,
    input  wire in11_valid, output wire in11_ready, input  wire [DATA-1:0] in11_data,
    input  wire in11_startofpacket, in11_endofpacket, input  wire [EMPTY-1:0] in11_empty,
    input  wire [OWN-1:0] in11_channel, input  wire [ERROR-1:0] in11_error,
    input  wire in12_valid, output wire in12_ready, input  wire [DATA-1:0] in12_data,
    input  wire in12_startofpacket, in12_endofpacket, input  wire [EMPTY-1:0] in12_empty,
    input  wire [OWN-1:0] in12_channel, input  wire [ERROR-1:0] in12_error,
    input  wire in13_valid, output wire in13_ready, input  wire [DATA-1:0] in13_data,
    input  wire in13_startofpacket, in13_endofpacket, input  wire [EMPTY-1:0] in13_empty,
    input  wire [OWN-1:0] in13_channel, input  wire [ERROR-1:0] in13_error,
    input  wire in14_valid, output wire in14_ready, input  wire [DATA-1:0] in14_data,
    input  wire in14_startofpacket, in14_endofpacket, input  wire [EMPTY-1:0] in14_empty,
    input  wire [OWN-1:0] in14_channel, input  wire [ERROR-1:0] in14_error,
    input  wire in15_valid, output wire in15_ready, input  wire [DATA-1:0] in15_data,
    input  wire in15_startofpacket, in15_endofpacket, input  wire [EMPTY-1:0] in15_empty,
    input  wire [OWN-1:0] in15_channel, input  wire [ERROR-1:0] in15_error,
    // verilator lint_on UNUSED

    output wire               out_valid,
    input  wire               out_ready,
    output wire [DATA-1:0]    out_data,
    output wire               out_startofpacket,
    output wire               out_endofpacket,
    output wire [EMPTY-1:0]   out_empty,
    output wire [CHANNEL-1:0] out_channel,
    output wire [ERROR-1:0]   out_error
);
    localparam WIDTH = 2 + EMPTY + ERROR + DATA;

    wire [15:0]         valid = {in15_valid, in14_valid, in13_valid, in12_valid, in11_valid,
                                 in10_valid, in9_valid, in8_valid, in7_valid, in6_valid,
                                 in5_valid, in4_valid, in3_valid, in2_valid, in1_valid,
                                 in0_valid};
    wire [16*WIDTH-1:0] words = {
        {in15_startofpacket, in15_endofpacket, in15_empty, in15_error, in15_data},
        {in14_startofpacket, in14_endofpacket, in14_empty, in14_error, in14_data},
        {in13_startofpacket, in13_endofpacket, in13_empty, in13_error, in13_data},
        {in12_startofpacket, in12_endofpacket, in12_empty, in12_error, in12_data},
        {in11_startofpacket, in11_endofpacket, in11_empty, in11_error, in11_data},
        {in10_startofpacket, in10_endofpacket, in10_empty, in10_error, in10_data},
        {in9_startofpacket, in9_endofpacket, in9_empty, in9_error, in9_data},
        {in8_startofpacket, in8_endofpacket, in8_empty, in8_error, in8_data},
        {in7_startofpacket, in7_endofpacket, in7_empty, in7_error, in7_data},
        {in6_startofpacket, in6_endofpacket, in6_empty, in6_error, in6_data},
        {in5_startofpacket, in5_endofpacket, in5_empty, in5_error, in5_data},
        {in4_startofpacket, in4_endofpacket, in4_empty, in4_error, in4_data},
        {in3_startofpacket, in3_endofpacket, in3_empty, in3_error, in3_data},
        {in2_startofpacket, in2_endofpacket, in2_empty, in2_error, in2_data},
        {in1_startofpacket, in1_endofpacket, in1_empty, in1_error, in1_data},
        {in0_startofpacket, in0_endofpacket, in0_empty, in0_error, in0_data}};
    wire [16*OWN-1:0]   channels = {
        in15_channel, in14_channel, in13_channel, in12_channel, in11_channel,
        in10_channel, in9_channel, in8_channel, in7_channel, in6_channel,
        in5_channel, in4_channel, in3_channel, in2_channel, in1_channel,
        in0_channel};
    wire [15:0]         ready = out_ready ? 16'd1 << chosen_q : 16'd0;

    assign {in15_ready, in14_ready, in13_ready, in12_ready, in11_ready,
            in10_ready, in9_ready, in8_ready, in7_ready, in6_ready,
            in5_ready, in4_ready, in3_ready, in2_ready, in1_ready,
            in0_ready} = ready;

    reg  [3:0]  chosen_q, next;
    reg  [15:0] count_q;     // words that the source may still send after this one
    reg         inside_q;    // a packet has begun
    wire        goes  = out_valid && out_ready;
    wire        stays = BY_PACKETS != 0 ? (goes ? !out_endofpacket : inside_q || out_valid)
                                        : out_valid && !(goes && count_q == 16'd0);
    wire [SELECT-1:0] number = chosen_q[SELECT-1:0];
    wire [OWN-1:0]    own    = channels[chosen_q*OWN +: OWN];

    // The next of those that have a word, in a circle.
    integer n, at;
    always @* begin
        next = chosen_q;
        for (n = COUNT; n > 0; n = n - 1) begin
            at = ({28'd0, chosen_q} + n) % COUNT;
            if (valid[at[3:0]]) next = at[3:0];
        end
    end

    assign out_valid = valid[chosen_q];
    assign {out_startofpacket, out_endofpacket, out_empty, out_error, out_data} =
        words[chosen_q*WIDTH +: WIDTH];
    generate
        if (CHANNEL == SELECT) begin : alone
            assign out_channel = number;
        end else if (HIGH != 0) begin : high
            assign out_channel = {number, own};
        end else begin : low
            assign out_channel = {own, number};
        end
    endgenerate

    always @(posedge clk) begin
        if (goes) begin
            count_q  <= count_q - 16'd1;
            inside_q <= !out_endofpacket;
        end
        if (!stays) begin
            chosen_q <= next;
            count_q  <= SIZE - 1;
        end
        if (!reset_n) begin
            chosen_q <= 4'd0;
            count_q  <= SIZE - 1;
            inside_q <= 1'b0;
        end
    end
endmodule

`default_nettype wire
