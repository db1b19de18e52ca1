// avalon_queue_formal.v - no word lost, none invented, none out of order, for any clocks
//
// As dual_clock_fifo_formal.v, for the queue of crossings: a memory, and no reset.  By 14-step
// induction.

`default_nettype none

module avalon_queue_formal (
    input wire       clk_i,
    input wire       to_clk_i,
    input wire       valid_i,
    input wire [1:0] data_i,
    input wire       ready_i
);
    wire       ready, valid;
    wire [1:0] data;

    de1sim_avalon_queue #(.WIDTH(2), .DEPTH_LOG2(1)) dut (
        .clk_i(clk_i), .valid_i(valid_i), .ready_o(ready), .data_i(data_i),
        .to_clk_i(to_clk_i), .valid_o(valid), .ready_i(ready_i), .data_o(data)
    );

    // ---- The reference: words in and out, modulo 4; the last four that came in ----
    reg       live = 1'b0;
    reg [1:0] in_q = 2'd0, out_q = 2'd0;
    reg [7:0] log_q;

    always @($global_clock) live <= 1'b1;
    always @(posedge clk_i) if (valid_i && ready) begin
        log_q[in_q * 2 +: 2] <= data_i;
        in_q <= in_q + 2'd1;
    end
    always @(posedge to_clk_i) if (valid && ready_i) out_q <= out_q + 2'd1;

    wire [1:0] held = in_q - out_q;

    // ---- How long a word has waited unseen, or room: in clocks of who looks ----
    reg [1:0] unseen_q = 2'd0, unfreed_q = 2'd0;

    always @(posedge to_clk_i)
        unseen_q <= held == 2'd0 || (ready_i && valid) ? 2'd0
                    : unseen_q == 2'd2 ? 2'd2 : unseen_q + 2'd1;
    always @(posedge clk_i)
        unfreed_q <= held == 2'd2 || (valid_i && ready) ? 2'd0
                     : unfreed_q == 2'd2 ? 2'd2 : unfreed_q + 2'd1;

    // ---- What must hold ----
    wire [1:0] dut__written_gray_q, dut__read_gray_q;
    reg  [1:0] written_was, read_was;

    always @($global_clock) begin
        written_was <= dut__written_gray_q;
        read_was    <= dut__read_gray_q;
    end

    always @(*) if (live) begin
        a_not_over: assert (held != 2'd3);
        if (held == 2'd0) a_none_invented: assert (!valid);
        if (held == 2'd2) a_none_overwritten: assert (!ready);
        if (valid) a_order: assert (data == log_q[out_q * 2 +: 2]);
        if (unseen_q == 2'd2) a_comes: assert (valid);
        if (unfreed_q == 2'd2) a_room_comes: assert (ready);
        a_one_bit_in:  assert ((dut__written_gray_q ^ written_was) != 2'b11);
        a_one_bit_out: assert ((dut__read_gray_q ^ read_was) != 2'b11);
    end

    // ---- Invariants: what each side has seen lies between the other's past and its presence ----
    wire [1:0] dut__written_q, dut__read_q;
    wire [1:0] dut__written_meta_q, dut__written_seen_q, dut__read_meta_q, dut__read_seen_q;
    wire [1:0] dut__words_q__0, dut__words_q__1;

    function [1:0] count;
        input [1:0] gray;
        count = {gray[1], gray[1] ^ gray[0]};
    endfunction

    wire [1:0] next = out_q + 2'd1;
    wire [1:0] came = count(dut__written_meta_q) - out_q;
    wire [1:0] seen = count(dut__written_seen_q) - out_q;
    wire [1:0] left = in_q - count(dut__read_meta_q);
    wire [1:0] told = in_q - count(dut__read_seen_q);

    always @(*) if (live) begin
        i_in:   assert (dut__written_q == in_q && count(dut__written_gray_q) == in_q);
        i_out:  assert (dut__read_q == out_q && count(dut__read_gray_q) == out_q);
        i_seen: assert (seen <= came && came <= held && held <= 2'd2);
        i_told: assert (held <= left && left <= told && told <= 2'd2);
        if (held != 2'd0)
            i_first: assert ((out_q[0] ? dut__words_q__1 : dut__words_q__0)
                             == log_q[out_q * 2 +: 2]);
        if (held == 2'd2)
            i_second: assert ((next[0] ? dut__words_q__1 : dut__words_q__0)
                              == log_q[next * 2 +: 2]);
        if (unseen_q != 2'd0) i_came: assert (came != 2'd0);
        if (unfreed_q != 2'd0) i_left: assert (left != 2'd2);
    end
endmodule

`default_nettype wire
