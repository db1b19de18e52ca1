// de1sim_hps_reads.v - reads of a master in the FPGA from the processor's memory
//
//   commands -> queue of eight -> when one is due: a word at each clock -> data
//
// Memory is read as the command is taken.  Bursts are answered in the order of their commands.

`default_nettype none

module de1sim_hps_reads #(
    parameter PORT = 0  // as in de1sim_hps_memory.vh
) (
    input  wire         clk_i,
    input  wire [5:0]   width_i,    // of the bus: bytes

    input  wire         valid_i,
    output wire         ready_o,
    input  wire [31:0]  address_i,
    input  wire [7:0]   beats_i,
    input  wire [2:0]   size_i,     // of a beat: the logarithm of its bytes
    input  wire [1:0]   burst_i,    // as AXI's ARBURST
    input  wire [7:0]   id_i,

    output reg          valid_o,
    input  wire         ready_i,
    output reg  [255:0] data_o,
    output reg  [1:0]   response_o,
    output reg          last_o,
    output reg  [7:0]   id_o
);
    `include "de1sim_hps_memory.vh"

    reg  [79:0]  bursts [0:7];      // beats, ID, when it is due
    reg  [3:0]   head_q = 4'd0, tail_q = 4'd0;
    reg          takes_q = 1'b0;
    reg          begun_q = 1'b0;    // with the burst at the head
    reg  [7:0]   left_q = 8'd0;     // beats

    wire [7:0]   beats, id;
    wire [63:0]  due;
    assign {beats, id, due} = bursts[head_q[2:0]];

    wire [7:0]   left    = begun_q ? left_q : beats;
    wire         is_last = left <= 8'd1;

    assign ready_o = takes_q && tail_q - head_q != 4'd8;

    // verilator lint_off UNUSED
    integer      answer;
    // verilator lint_on UNUSED
    reg  [255:0] word;
    // verilator lint_off BLKSEQ
    always @(posedge clk_i) begin
        if (valid_i) begin
            answer  = de1sim_hps_takes(PORT);
            takes_q <= answer[0];
        end
        if (valid_i && ready_o) begin
            bursts[tail_q[2:0]] <= {beats_i, id_i,
                de1sim_hps_begin(PORT, 0, address_i, {24'd0, beats_i}, {29'd0, size_i},
                                 {30'd0, burst_i}, {26'd0, width_i})};
            tail_q <= tail_q + 4'd1;
        end
        if (!valid_o || ready_i) begin
            valid_o <= 1'b0;
            if (head_q != tail_q && (begun_q || de1sim_hps_time() >= due)) begin
                answer = de1sim_hps_read(PORT, word);
                valid_o    <= 1'b1;
                data_o     <= word;
                response_o <= answer[1:0];
                last_o     <= is_last;
                id_o       <= id;
                begun_q    <= !is_last;
                left_q     <= left - 8'd1;
                if (is_last) head_q <= head_q + 4'd1;
            end
        end
    end
    // verilator lint_on BLKSEQ
endmodule

`default_nettype wire
