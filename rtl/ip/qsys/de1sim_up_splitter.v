// de1sim_up_splitter.v - the University Program's stream router that splits: each packet goes to
// one of two sources
//
// stream_select counts between packets; sync tells it to the router that merges
// (de1sim_up_merger.v).

`default_nettype none

module de1sim_up_splitter #(parameter BITS = 24) (
    input  wire            clk,
    input  wire            reset,
    input  wire            stream_select,

    input  wire [BITS-1:0] stream_in_data,
    input  wire            stream_in_startofpacket,
    input  wire            stream_in_endofpacket,
    input  wire            stream_in_valid,
    output wire            stream_in_ready,

    output wire [BITS-1:0] stream_out_data_0,
    output wire            stream_out_startofpacket_0,
    output wire            stream_out_endofpacket_0,
    output wire            stream_out_valid_0,
    input  wire            stream_out_ready_0,

    output wire [BITS-1:0] stream_out_data_1,
    output wire            stream_out_startofpacket_1,
    output wire            stream_out_endofpacket_1,
    output wire            stream_out_valid_1,
    input  wire            stream_out_ready_1,

    output reg             sync_data,
    output reg             sync_valid,
    input  wire            sync_ready
);
    reg  inside_q, choice_q;
    wire taken   = stream_in_valid && stream_in_ready;
    wire chooses = taken ? stream_in_endofpacket || !(inside_q || stream_in_startofpacket)
                         : !inside_q;

    assign stream_in_ready            = choice_q ? stream_out_ready_1 : stream_out_ready_0;
    assign stream_out_valid_0         = stream_in_valid && !choice_q;
    assign stream_out_valid_1         = stream_in_valid && choice_q;
    assign stream_out_data_0          = stream_in_data;
    assign stream_out_data_1          = stream_in_data;
    assign stream_out_startofpacket_0 = stream_in_startofpacket;
    assign stream_out_startofpacket_1 = stream_in_startofpacket;
    assign stream_out_endofpacket_0   = stream_in_endofpacket;
    assign stream_out_endofpacket_1   = stream_in_endofpacket;

    always @(posedge clk) begin
        if (taken) inside_q <= !stream_in_endofpacket && (inside_q || stream_in_startofpacket);
        if (sync_ready) sync_valid <= 1'b0;
        if (chooses) begin
            choice_q   <= stream_select;
            sync_data  <= stream_select;
            sync_valid <= 1'b1;
        end
        if (reset) {inside_q, choice_q, sync_data, sync_valid} <= 4'd0;
    end
endmodule

`default_nettype wire
