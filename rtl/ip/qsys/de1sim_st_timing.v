// de1sim_st_timing.v - a stream from one ready latency to another, and where a side has no ready or
// valid
//
//   source's latency = sink's    nothing between        sink without ready    the source is ready
//                    < sink's    ready comes later      source without ready  what comes while the
//                    > sink's    through a FIFO                               sink is not is lost
//
// A source without valid has data in each ready cycle.

`default_nettype none

module de1sim_st_timing #(
    parameter WIDTH       = 8,
    parameter IN_LATENCY  = 0,
    parameter IN_READY    = 1,  // whether the side has the signal
    parameter IN_VALID    = 1,
    parameter OUT_LATENCY = 0,
    parameter OUT_READY   = 1
) (
    // verilator lint_off UNUSED
    input  wire             clk_i,
    input  wire             rst_i,
    input  wire             valid_i,
    input  wire             ready_i,
    // verilator lint_on UNUSED
    output wire             ready_o,
    input  wire [WIDTH-1:0] data_i,

    output wire             valid_o,
    output wire [WIDTH-1:0] data_o
);
    localparam LATER = OUT_LATENCY > IN_LATENCY ? OUT_LATENCY - IN_LATENCY : 1;
    localparam KEPT  = IN_LATENCY > OUT_LATENCY ? IN_LATENCY : OUT_LATENCY;

    // verilator lint_off UNUSED
    reg  [KEPT:0] sent_q;    // ready to the source, a clock ago and before
    reg  [KEPT:0] heard_q;   // of the sink
    // verilator lint_on UNUSED
    wire [KEPT+1:0] sent  = {sent_q, ready_o};
    wire [KEPT+1:0] heard = {heard_q, ready_i || OUT_READY == 0};
    wire            valid = IN_VALID != 0 ? valid_i : IN_READY == 0 || sent[IN_LATENCY];

    always @(posedge clk_i) begin
        sent_q  <= rst_i ? {KEPT+1{1'b0}} : sent[KEPT:0];
        heard_q <= rst_i ? {KEPT+1{1'b0}} : heard[KEPT:0];
    end

    generate
        if (OUT_READY == 0 || IN_READY == 0) begin : one_way
            assign ready_o = 1'b1;
            assign valid_o = valid && (OUT_LATENCY == 0 || heard[OUT_LATENCY]);
            assign data_o  = data_i;
        end else if (IN_LATENCY == OUT_LATENCY) begin : straight
            assign ready_o = ready_i;
            assign valid_o = valid;
            assign data_o  = data_i;
        end else if (IN_LATENCY < OUT_LATENCY) begin : later
            assign ready_o = heard[LATER];
            assign valid_o = valid && (IN_LATENCY != 0 || ready_o);
            assign data_o  = data_i;
        end else begin : kept
            reg  [WIDTH-1:0] words_q [0:15];
            reg  [3:0]       in_q, out_q;
            wire [3:0]       used = in_q - out_q;
            wire             goes = valid_o && (OUT_LATENCY != 0 || ready_i);

            assign ready_o = used < 4'd8;   // up to four more come
            assign valid_o = used != 4'd0 && (OUT_LATENCY == 0 || heard[OUT_LATENCY]);
            assign data_o  = words_q[out_q];
            always @(posedge clk_i) begin
                if (valid) words_q[in_q] <= data_i;
                in_q  <= rst_i ? 4'd0 : in_q + {3'd0, valid};
                out_q <= rst_i ? 4'd0 : out_q + {3'd0, goes};
            end
        end
    endgenerate
endmodule

`default_nettype wire
