// de1sim_up_merger.v - the University Program's stream router that merges: one of two sinks at a
// time, by whole packets
//
// With SYNC the router that splits says which is next (de1sim_up_splitter.v), else stream_select.

`default_nettype none

module de1sim_up_merger #(parameter BITS = 24, SYNC = 1) (
    input  wire            clk,
    input  wire            reset,
    // verilator lint_off UNUSED
    input  wire            stream_select,
    input  wire            sync_data,
    input  wire            sync_valid,
    // verilator lint_on UNUSED
    output wire            sync_ready,

    input  wire [BITS-1:0] stream_in_data_0,
    input  wire            stream_in_startofpacket_0,
    input  wire            stream_in_endofpacket_0,
    input  wire            stream_in_valid_0,
    output wire            stream_in_ready_0,

    input  wire [BITS-1:0] stream_in_data_1,
    input  wire            stream_in_startofpacket_1,
    input  wire            stream_in_endofpacket_1,
    input  wire            stream_in_valid_1,
    output wire            stream_in_ready_1,

    output wire [BITS-1:0] stream_out_data,
    output wire            stream_out_startofpacket,
    output wire            stream_out_endofpacket,
    output wire            stream_out_valid,
    input  wire            stream_out_ready
);
    reg  inside_q, choice_q;
    wire taken   = stream_out_valid && stream_out_ready;
    wire chooses = taken ? stream_out_endofpacket || !(inside_q || stream_out_startofpacket)
                         : !inside_q;

    assign sync_ready        = chooses;
    assign stream_in_ready_0 = stream_out_ready && !choice_q;
    assign stream_in_ready_1 = stream_out_ready && choice_q;
    assign stream_out_data   = choice_q ? stream_in_data_1 : stream_in_data_0;
    assign stream_out_valid  = choice_q ? stream_in_valid_1 : stream_in_valid_0;
    assign stream_out_startofpacket = choice_q ? stream_in_startofpacket_1
                                               : stream_in_startofpacket_0;
    assign stream_out_endofpacket   = choice_q ? stream_in_endofpacket_1
                                               : stream_in_endofpacket_0;

    always @(posedge clk) begin
        if (taken) inside_q <= !stream_out_endofpacket && (inside_q || stream_out_startofpacket);
        if (chooses && (SYNC == 0 || sync_valid)) choice_q <= SYNC != 0 ? sync_data : stream_select;
        if (reset) {inside_q, choice_q} <= 2'd0;
    end
endmodule

`default_nettype wire
