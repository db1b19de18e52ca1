// fifo_formal.v - no word lost, none invented, none out of order; the flags. By 4-step induction.
//
// The three FIFOs side by side.  The reference is a shift register of four words: a push appends, a
// pop moves all down.

`default_nettype none

module fifo_formal (
    input wire       clk_i,
    input wire       rst_i,
    input wire       clear_i,
    input wire       push_i,
    input wire [3:0] wdata_i,
    input wire       pop_i
);
    wire [3:0] rdata;
    wire [2:0] count;
    wire       full, empty;

    fifo #(.WIDTH(4), .DEPTH_LOG2(2)) dut (
        .clk_i(clk_i), .rst_i(rst_i), .clear_i(clear_i), .push_i(push_i), .wdata_i(wdata_i),
        .pop_i(pop_i), .rdata_o(rdata), .count_o(count), .full_o(full), .empty_o(empty)
    );

    wire [3:0] small_rdata, shift_rdata;
    wire [2:0] small_count, shift_count;

    small_fifo #(.WIDTH(4), .DEPTH_LOG2(2)) small (
        .clk_i(clk_i), .rst_i(rst_i || clear_i), .push_i(push_i), .wdata_i(wdata_i),
        .pop_i(pop_i), .rdata_o(small_rdata), .count_o(small_count)
    );
    shift_fifo #(.WIDTH(4), .DEPTH_LOG2(2)) shift (
        .clk_i(clk_i), .rst_i(rst_i || clear_i), .push_i(push_i), .wdata_i(wdata_i),
        .pop_i(pop_i), .rdata_o(shift_rdata), .count_o(shift_count)
    );

    // ---- The reference ----
    reg        live = 1'b0;
    reg  [2:0] words_q;
    reg  [3:0] first_q, second_q, third_q, fourth_q, gone_q;
    reg        was_q;                           // a word was popped, and nothing else came since
    wire       push = push_i && words_q != 3'd4;
    wire       pop  = pop_i && words_q != 3'd0;
    wire [2:0] left = words_q - {2'd0, pop};

    always @(posedge clk_i) begin
        live     <= 1'b1;
        words_q  <= left + {2'd0, push};
        first_q  <= push && left == 3'd0 ? wdata_i : pop ? second_q : first_q;
        second_q <= push && left == 3'd1 ? wdata_i : pop ? third_q : second_q;
        third_q  <= push && left == 3'd2 ? wdata_i : pop ? fourth_q : third_q;
        fourth_q <= push && left == 3'd3 ? wdata_i : fourth_q;
        if (pop) gone_q <= first_q;
        was_q    <= !rst_i && !clear_i && !push && (pop || was_q);
        if (rst_i || clear_i) words_q <= 3'd0;
    end

    always @(*) if (!live) assume (rst_i);

    // ---- What must hold ----
    always @(*) if (live) begin
        a_count: assert (count == words_q);
        a_full:  assert (full == (words_q == 3'd4));
        a_empty: assert (empty == (words_q == 3'd0));
        a_small_count: assert (small_count == words_q);
        a_shift_count: assert (shift_count == words_q);
        if (words_q == 3'd0 && was_q) a_last: assert (rdata == gone_q);
        if (words_q != 3'd0) begin
            a_order:       assert (rdata == first_q);
            a_small_order: assert (small_rdata == first_q);
            a_shift_order: assert (shift_rdata == first_q);
        end
    end

    // ---- Invariants: the words after the head lie in the memory ----
    wire [1:0] dut__read_q, dut__write_q;
    wire [3:0] dut__memory__0, dut__memory__1, dut__memory__2, dut__memory__3;
    function [3:0] word_at;
        input [1:0] place;
        word_at = place == 2'd0 ? dut__memory__0 : place == 2'd1 ? dut__memory__1
                  : place == 2'd2 ? dut__memory__2 : dut__memory__3;
    endfunction

    wire [15:0] shift__words_q;
    wire [1:0]  small__read_q, small__write_q;
    wire [3:0]  small__memory__0, small__memory__1, small__memory__2, small__memory__3;
    function [3:0] small_at;
        input [1:0] place;
        small_at = place == 2'd0 ? small__memory__0 : place == 2'd1 ? small__memory__1
                   : place == 2'd2 ? small__memory__2 : small__memory__3;
    endfunction

    always @(*) if (live) begin
        i_pointers: assert (dut__write_q == dut__read_q + words_q[1:0]);
        if (words_q > 3'd1) i_second: assert (word_at(dut__read_q + 2'd1) == second_q);
        if (words_q > 3'd2) i_third:  assert (word_at(dut__read_q + 2'd2) == third_q);
        if (words_q > 3'd3) i_fourth: assert (word_at(dut__read_q + 2'd3) == fourth_q);
        if (words_q > 3'd1) i_shift2: assert (shift__words_q[7:4] == second_q);
        if (words_q > 3'd2) i_shift3: assert (shift__words_q[11:8] == third_q);
        if (words_q > 3'd3) i_shift4: assert (shift__words_q[15:12] == fourth_q);
        i_small_pointers: assert (small__write_q == small__read_q + words_q[1:0]);
        if (words_q > 3'd1) i_small2: assert (small_at(small__read_q + 2'd1) == second_q);
        if (words_q > 3'd2) i_small3: assert (small_at(small__read_q + 2'd2) == third_q);
        if (words_q > 3'd3) i_small4: assert (small_at(small__read_q + 2'd3) == fourth_q);
    end
endmodule

`default_nettype wire
