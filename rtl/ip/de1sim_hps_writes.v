// de1sim_hps_writes.v - writes of a master in the FPGA to the processor's memory
//
//   commands -> queue of eight -+-> memory, a word at each clock -> responses, when they are due
//   data -----------------------+
//
// A word is taken with its command, or after it, and is in the memory at that clock.

`default_nettype none

module de1sim_hps_writes #(
    parameter PORT = 0  // as in de1sim_hps_memory.vh
) (
    input  wire         clk_i,
    input  wire [5:0]   width_i,    // of the bus: bytes

    input  wire         valid_i,
    output wire         ready_o,
    input  wire [31:0]  address_i,
    input  wire [7:0]   beats_i,
    input  wire [2:0]   size_i,     // of a beat: the logarithm of its bytes
    input  wire [1:0]   burst_i,    // as AXI's AWBURST
    input  wire [7:0]   id_i,

    input  wire         data_valid_i,
    output wire         data_ready_o,
    output wire         data_last_o,  // the word is the last of its burst
    input  wire [255:0] data_i,
    input  wire [31:0]  strobes_i,

    output reg          valid_o,
    input  wire         ready_i,
    output reg  [1:0]   response_o,
    output reg  [7:0]   id_o
);
    `include "de1sim_hps_memory.vh"

    reg  [79:0]  bursts [0:7];                  // beats, ID, when it is written
    reg  [1:0]   responses [0:7];
    reg  [3:0]   head_q = 4'd0, tail_q = 4'd0;  // bursts head_q to tail_q - 1 want data,
    reg  [3:0]   answered_q = 4'd0;             // answered_q to head_q - 1 an answer
    reg          takes_q = 1'b0;
    reg          begun_q = 1'b0;                // with the burst at the head
    reg  [7:0]   left_q = 8'd0;                 // beats
    reg  [1:0]   worst_q = 2'd0;                // response of the words before

    wire         is_empty = head_q == tail_q;
    wire [7:0]   answered_id;
    wire [63:0]  answered_due;
    // verilator lint_off UNUSED
    wire [79:0]  head     = bursts[head_q[2:0]];
    wire [79:0]  answered = bursts[answered_q[2:0]];
    // verilator lint_on UNUSED
    assign {answered_id, answered_due} = answered[71:0];

    wire [7:0]   left = begun_q ? left_q : is_empty ? beats_i : head[79:72];

    assign ready_o      = takes_q && tail_q - answered_q != 4'd8;
    assign data_ready_o = takes_q && (!is_empty || (valid_i && ready_o));
    assign data_last_o  = left <= 8'd1;

    // verilator lint_off UNUSED
    integer      answer;
    // verilator lint_on UNUSED
    reg  [1:0]   worst;
    // verilator lint_off BLKSEQ
    always @(posedge clk_i) begin
        if (valid_i || data_valid_i) begin
            answer  = de1sim_hps_takes(PORT);
            takes_q <= answer[0];
        end
        if (valid_i && ready_o) begin
            bursts[tail_q[2:0]] <= {beats_i, id_i,
                de1sim_hps_begin(PORT, 1, address_i, {24'd0, beats_i}, {29'd0, size_i},
                                 {30'd0, burst_i}, {26'd0, width_i})};
            tail_q <= tail_q + 4'd1;
        end
        if (data_valid_i && data_ready_o) begin
            answer = de1sim_hps_write(PORT, strobes_i, data_i);
            worst  = begun_q && worst_q > answer[1:0] ? worst_q : answer[1:0];
            responses[head_q[2:0]] <= worst;
            worst_q <= worst;
            begun_q <= !data_last_o;
            left_q  <= left - 8'd1;
            if (data_last_o) head_q <= head_q + 4'd1;
        end
        if (!valid_o || ready_i) begin
            valid_o <= 1'b0;
            if (answered_q != head_q && de1sim_hps_time() >= answered_due) begin
                valid_o    <= 1'b1;
                response_o <= responses[answered_q[2:0]];
                id_o       <= answered_id;
                answered_q <= answered_q + 4'd1;
            end
        end
    end
    // verilator lint_on BLKSEQ
endmodule

`default_nettype wire
