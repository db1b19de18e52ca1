// dual_clock_fifo_formal.v - no word lost, none invented, none out of order, for any clocks
//
// Both clocks are free: each may tick at any time, or both at once, or one never.  The reference is
// a log of the words that were pushed.  By 14-step induction.

`default_nettype none

module dual_clock_fifo_formal (
    input wire       wclk_i,
    input wire       rclk_i,
    input wire       push_i,
    input wire [1:0] wdata_i,
    input wire       pop_i
);
    // ---- A reset in which both clocks tick three times ----
    reg  [2:0] age = 3'd0;
    wire       live = age == 3'd6;
    wire       rst  = !live;

    always @($global_clock) if (!live) age <= age + 3'd1;
    always @(*) if (!live) begin
        assume (wclk_i == age[0]);
        assume (rclk_i == age[0]);
    end

    wire       full, empty, wawake, rawake;
    wire [1:0] rdata;

    dual_clock_fifo #(.WIDTH(2), .DEPTH_LOG2(1)) dut (
        .wclk_i(wclk_i), .wrst_i(rst), .push_i(push_i), .wdata_i(wdata_i), .full_o(full),
        .wawake_o(wawake), .rclk_i(rclk_i), .rrst_i(rst), .pop_i(pop_i), .rdata_o(rdata),
        .empty_o(empty), .rawake_o(rawake)
    );

    // ---- The reference: words pushed and popped, modulo 4; the last four that were pushed ----
    reg [1:0] pushed_q, popped_q;
    reg [7:0] log_q;

    always @(posedge wclk_i) begin
        if (push_i && !full) begin
            log_q[pushed_q * 2 +: 2] <= wdata_i;
            pushed_q <= pushed_q + 2'd1;
        end
        if (rst) pushed_q <= 2'd0;
    end
    always @(posedge rclk_i) begin
        if (pop_i && !empty) popped_q <= popped_q + 2'd1;
        if (rst) popped_q <= 2'd0;
    end

    wire [1:0] held = pushed_q - popped_q;

    // ---- How long a word has waited unseen, or room: in clocks of who looks ----
    reg [1:0] unseen_q, unfreed_q;

    always @(posedge rclk_i)
        unseen_q <= rst || held == 2'd0 || (pop_i && !empty) ? 2'd0
                    : unseen_q == 2'd2 ? 2'd2 : unseen_q + 2'd1;
    always @(posedge wclk_i)
        unfreed_q <= rst || held == 2'd2 || (push_i && !full) ? 2'd0
                     : unfreed_q == 2'd2 ? 2'd2 : unfreed_q + 2'd1;

    // ---- What must hold ----
    wire [1:0] dut__write_gray_q, dut__read_gray_q;
    reg  [1:0] write_was, read_was;

    always @($global_clock) begin
        write_was <= dut__write_gray_q;
        read_was  <= dut__read_gray_q;
    end

    always @(*) if (live) begin
        a_not_over: assert (held != 2'd3);
        if (held == 2'd0) a_none_invented: assert (empty);
        if (held == 2'd2) a_none_overwritten: assert (full);
        if (!empty) a_order: assert (rdata == log_q[popped_q * 2 +: 2]);
        if (unseen_q == 2'd2) a_comes: assert (!empty);
        if (unfreed_q == 2'd2) a_room_comes: assert (!full);
        a_one_bit_of_write: assert ((dut__write_gray_q ^ write_was) != 2'b11);
        a_one_bit_of_read:  assert ((dut__read_gray_q ^ read_was) != 2'b11);
        if (empty != (held == 2'd0)) a_rawake: assert (rawake);
        if (full != (held == 2'd2)) a_wawake: assert (wawake);
    end

    // ---- Invariants: what each side has seen lies between the other's past and its presence ----
    wire [1:0] dut__write_q, dut__read_q;
    wire [1:0] dut__write_sync__meta_q, dut__write_seen, dut__read_sync__meta_q, dut__read_seen;
    wire [3:0] dut__words_q;

    function [1:0] count;
        input [1:0] gray;
        count = {gray[1], gray[1] ^ gray[0]};
    endfunction

    wire [1:0] next = popped_q + 2'd1;
    wire [1:0] came = count(dut__write_sync__meta_q) - popped_q;
    wire [1:0] seen = count(dut__write_seen) - popped_q;
    wire [1:0] left = pushed_q - count(dut__read_sync__meta_q);
    wire [1:0] told = pushed_q - count(dut__read_seen);

    always @(*) if (live) begin
        i_write: assert (dut__write_q == pushed_q && count(dut__write_gray_q) == pushed_q);
        i_read:  assert (dut__read_q == popped_q && count(dut__read_gray_q) == popped_q);
        i_seen:  assert (seen <= came && came <= held && held <= 2'd2);
        i_told:  assert (held <= left && left <= told && told <= 2'd2);
        if (held != 2'd0)
            i_first: assert (dut__words_q[popped_q[0] * 2 +: 2] == log_q[popped_q * 2 +: 2]);
        if (held == 2'd2)
            i_second: assert (dut__words_q[next[0] * 2 +: 2] == log_q[next * 2 +: 2]);
        if (unseen_q != 2'd0) i_came: assert (came != 2'd0);
        if (unfreed_q != 2'd0) i_left: assert (left != 2'd2);
    end
endmodule

`default_nettype wire
