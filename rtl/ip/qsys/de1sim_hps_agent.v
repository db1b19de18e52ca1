// de1sim_hps_agent.v - the interconnect's commands at the processor's memory
//
// Commands and answers as in de1sim_avalon_decoder.v.  Each is a burst of one word; up to 64 are
// on their way.  A read that does not enable all bytes is of as few as hold those.

`default_nettype none

module de1sim_hps_agent #(
    parameter PORT  = 0,   // as in de1sim_hps_memory.vh
    parameter WIDTH = 64,  // 32 to 256
    parameter BYTES = WIDTH / 8
) (
    input  wire             clk_i,
    input  wire             rst_i,

    input  wire             valid_i,
    output wire             ready_o,
    input  wire             write_i,
    input  wire [31:0]      address_i,  // in bytes
    input  wire [WIDTH-1:0] wdata_i,
    input  wire [BYTES-1:0] be_i,
    output reg              rvalid_o,
    output reg  [WIDTH-1:0] rdata_o
);
`ifdef DE1SIM_LISTS
    // The design alone, without the chip.
    assign ready_o = 1'b0;
`else
    `include "de1sim_hps_memory.vh"

    localparam [6:0] MOST = 7'd64;

    reg  [63:0]  due [0:63];     // ps
    reg          reads [0:63];
    reg  [6:0]   head_q = 7'd0, tail_q = 7'd0;
    reg          takes_q = 1'b0;

    assign ready_o = takes_q && tail_q - head_q != MOST;

    // ---- The smallest part of the bus that holds the bytes ----

    reg  [4:0]   first, last;
    integer      n;
    always @* begin
        first = 5'd0;
        last  = 5'd0;
        for (n = BYTES - 1; n >= 0; n = n - 1) if (be_i[n]) first = n[4:0];
        for (n = 0; n < BYTES; n = n + 1) if (be_i[n]) last = n[4:0];
    end
    wire [4:0]   differ = first ^ last;
    wire [2:0]   size = differ[4] ? 3'd5 : differ[3] ? 3'd4 : differ[2] ? 3'd3
                      : differ[1] ? 3'd2 : {2'd0, differ[0]};
    wire [31:0]  base = address_i & ~(BYTES - 1);
    wire [31:0]  address = base | ({27'd0, first} >> size << size);

    // verilator lint_off UNUSED
    integer      answer;
    reg  [255:0] word;
    // verilator lint_on UNUSED
    // verilator lint_off BLKSEQ
    always @(posedge clk_i) begin
        if (valid_i) begin
            answer  = de1sim_hps_takes(PORT);
            takes_q <= answer[0];
        end
        if (valid_i && ready_o) begin
            due[tail_q[5:0]]   <= de1sim_hps_begin(PORT, {31'd0, write_i}, write_i ? base : address,
                                                   1, write_i ? $clog2(BYTES) : {29'd0, size}, 1,
                                                   BYTES);
            reads[tail_q[5:0]] <= !write_i;
            tail_q <= tail_q + 7'd1;
            if (write_i)
                answer = de1sim_hps_write(PORT, {{32-BYTES{1'b0}}, be_i},
                                          {{256-WIDTH{1'b0}}, wdata_i});
        end
        rvalid_o <= 1'b0;
        if (head_q != tail_q && de1sim_hps_time() >= due[head_q[5:0]]) begin
            if (reads[head_q[5:0]]) answer = de1sim_hps_read(PORT, word);
            rvalid_o <= 1'b1;
            rdata_o  <= word[WIDTH-1:0];
            head_q   <= head_q + 7'd1;
        end
        if (rst_i) takes_q <= 1'b0;
    end
    // verilator lint_on BLKSEQ
`endif
endmodule

`default_nettype wire
