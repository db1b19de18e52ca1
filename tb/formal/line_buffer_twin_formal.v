// line_buffer_twin_formal.v - of the simulation's line buffer: words are kept; a block is flat
// where it equals the pixel before it.
//
// By 3-step induction, for a place that the solver chooses.  Words are written in ascending order,
// from the first on; any number of them.  So the claims about a block hold from when it has been
// written completely until its row begins again.

`default_nettype none

module line_buffer_twin_formal (
    input wire        clk_i,
    input wire        we_i,
    input wire [8:0]  windex_i,
    input wire [31:0] wdata_i,
    input wire        re_i,
    input wire [8:0]  rindex_i
);
    (* anyconst *) reg [8:0] place;
    wire [31:0] rdata, other_rdata;
    wire        twin__flat;
    wire        flat = twin__flat;

    // A read changes nothing but its own result.  So one instance always reads the chosen place,
    // and the other reads any place.
    line_buffer_twin twin (
        .wclk_i(clk_i), .we_i(we_i), .windex_i(windex_i), .wdata_i(wdata_i),
        .rclk_i(clk_i), .re_i(1'b1), .rindex_i(place), .rdata_o(rdata)
    );
    line_buffer_twin other (
        .wclk_i(clk_i), .we_i(we_i), .windex_i(windex_i), .wdata_i(wdata_i),
        .rclk_i(clk_i), .re_i(re_i), .rindex_i(rindex_i), .rdata_o(other_rdata)
    );

    // ---- The reference ----
    wire [8:0]  block = {place[8:3], 3'd0};      // its first word
    reg         begun_q = 1'b0;                  // a row has begun
    reg         written_q = 1'b0, read_q = 1'b0, ran_q = 1'b0, re_q, whole_q = 1'b0;
    reg  [8:0]  last_q;                          // where the last word went
    reg  [31:0] word_q, word_was_q, other_q;     // at the place
    reg  [15:0] before_q;                        // the pixel before the block
    reg         same_q;                          // as which all of its pixels so far are
    wire        first = we_i && windex_i[7:0] == 8'd0;

    always @(posedge clk_i) begin
        ran_q      <= 1'b1;
        re_q       <= re_i;
        other_q    <= other_rdata;
        read_q     <= written_q;
        word_was_q <= word_q;
        if (we_i) begin
            begun_q <= 1'b1;
            last_q  <= windex_i;
            if (windex_i == place) begin
                written_q <= 1'b1;
                word_q    <= wdata_i;
            end
            if (windex_i == block - 9'd1) before_q <= wdata_i[31:16];
            if (windex_i[8:3] == block[8:3])
                same_q <= wdata_i == {before_q, before_q} && (same_q || windex_i == block);
            if (windex_i == block + 9'd7) whole_q <= 1'b1;
            if (first && windex_i[8] == place[8]) whole_q <= 1'b0;
        end
    end
    always @(*) assume (!we_i || first || (begun_q && windex_i == last_q + 9'd1));

    // ---- What must hold ----
    wire        in_picture = block[7:0] < 8'd160;
    always @(*) begin
        a_kept:  assert (!read_q || rdata == word_was_q);
        a_stays: assert (!ran_q || re_q || other_rdata == other_q);
        a_flat:  assert (!(flat && whole_q) || (written_q && word_q == {before_q, before_q}));
        a_each_flat_block: assert (!(whole_q && same_q && in_picture)
                                   || flat || block[7:0] == 8'd0);
        a_first_block_is_not_flat: assert (!flat || block[7:0] != 8'd0);
    end

    // ---- Invariants, while the block is being written ----
    wire        twin__so_far_q;
    wire [15:0] twin__last_q;
    wire        inside = begun_q && last_q >= block && last_q < block + 9'd7;
    always @(*) begin
        i_begins: assert (!begun_q || last_q != block - 9'd1 || twin__last_q == before_q);
        i_before: assert (!(inside && twin__so_far_q) || block[7:0] == 8'd0
                          || twin__last_q == before_q);
        i_so_far: assert (!(inside && twin__so_far_q && last_q >= place) || block[7:0] == 8'd0
                          || word_q == {before_q, before_q});
        i_same:   assert (!inside || block[7:0] == 8'd0 || twin__so_far_q == same_q);
        i_written: assert (!(inside && last_q >= place) || written_q);
        i_whole:  assert (!whole_q || (begun_q && written_q
                          && !(last_q[8] == place[8] && last_q < block + 9'd7)));
    end
endmodule

`default_nettype wire
