// line_buffer_formal.v - words are kept, and what was read stays.
//
// By 3-step induction, for a place that the solver chooses.
//
// With TWIN it is said of the simulation's file, and that a block is flat where it equals the pixel
// before it.  Words are then written in ascending order, from the first on; any number of them.
// So the claims about a block hold from when it has been written completely until its row begins
// again.

`default_nettype none

module line_buffer_formal (
    input wire        clk_i,
    input wire        we_i,
    input wire [8:0]  windex_i,
    input wire [31:0] wdata_i,
    input wire        re_i,
    input wire [8:0]  rindex_i
);
    (* anyconst *) reg [8:0] place;
    wire [31:0] rdata, other_rdata;

    // A read changes nothing but its own result.  So one instance always reads the chosen place,
    // and the other reads any place.
`ifdef TWIN
    line_buffer_twin dut (
`else
    line_buffer dut (
`endif
        .wclk_i(clk_i), .we_i(we_i), .windex_i(windex_i), .wdata_i(wdata_i),
        .rclk_i(clk_i), .re_i(1'b1), .rindex_i(place), .rdata_o(rdata)
    );
`ifdef TWIN
    line_buffer_twin other (
`else
    line_buffer other (
`endif
        .wclk_i(clk_i), .we_i(we_i), .windex_i(windex_i), .wdata_i(wdata_i),
        .rclk_i(clk_i), .re_i(re_i), .rindex_i(rindex_i), .rdata_o(other_rdata)
    );

    // ---- The reference ----
    reg         written_q = 1'b0, read_q = 1'b0, ran_q = 1'b0, re_q;
    reg  [31:0] word_q, word_was_q, other_q;     // at the place

    always @(posedge clk_i) begin
        ran_q      <= 1'b1;
        re_q       <= re_i;
        other_q    <= other_rdata;
        read_q     <= written_q;
        word_was_q <= word_q;
        if (we_i && windex_i == place) begin
            written_q <= 1'b1;
            word_q    <= wdata_i;
        end
    end

    always @(*) begin
        a_kept:  assert (!read_q || rdata == word_was_q);
        a_stays: assert (!ran_q || re_q || other_rdata == other_q);
    end

`ifdef TWIN
    // ---- Flat blocks ----
    wire        dut__flat;
    wire        flat  = dut__flat;
    wire [8:0]  block = {place[8:3], 3'd0};      // its first word
    reg         begun_q = 1'b0;                  // a row has begun
    reg         whole_q = 1'b0;
    reg  [8:0]  last_q;                          // where the last word went
    reg  [15:0] before_q;                        // the pixel before the block
    reg         same_q;                          // as which all of its pixels so far are
    wire        first = we_i && windex_i[7:0] == 8'd0;

    always @(posedge clk_i) if (we_i) begin
        begun_q <= 1'b1;
        last_q  <= windex_i;
        if (windex_i == block - 9'd1) before_q <= wdata_i[31:16];
        if (windex_i[8:3] == block[8:3])
            same_q <= wdata_i == {before_q, before_q} && (same_q || windex_i == block);
        if (windex_i == block + 9'd7) whole_q <= 1'b1;
        if (first && windex_i[8] == place[8]) whole_q <= 1'b0;
    end
    always @(*) assume (!we_i || first || (begun_q && windex_i == last_q + 9'd1));

    wire        in_picture = block[7:0] < 8'd160;
    always @(*) begin
        a_flat:  assert (!(flat && whole_q) || (written_q && word_q == {before_q, before_q}));
        a_each_flat_block: assert (!(whole_q && same_q && in_picture)
                                   || flat || block[7:0] == 8'd0);
        a_first_block_is_not_flat: assert (!flat || block[7:0] != 8'd0);
    end

    // ---- Invariants, while the block is being written ----
    wire        dut__so_far_q;
    wire [15:0] dut__last_q;
    wire        inside = begun_q && last_q >= block && last_q < block + 9'd7;
    always @(*) begin
        i_begins: assert (!begun_q || last_q != block - 9'd1 || dut__last_q == before_q);
        i_before: assert (!(inside && dut__so_far_q) || block[7:0] == 8'd0
                          || dut__last_q == before_q);
        i_so_far: assert (!(inside && dut__so_far_q && last_q >= place) || block[7:0] == 8'd0
                          || word_q == {before_q, before_q});
        i_same:   assert (!inside || block[7:0] == 8'd0 || dut__so_far_q == same_q);
        i_written: assert (!(inside && last_q >= place) || written_q);
        i_whole:  assert (!whole_q || (begun_q && written_q
                          && !(last_q[8] == place[8] && last_q < block + 9'd7)));
    end
`endif
endmodule

`default_nettype wire
