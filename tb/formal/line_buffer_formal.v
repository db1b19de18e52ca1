// line_buffer_formal.v - words are kept, and what was read stays.
//
// By 3-step induction, for a place that the solver chooses.

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
    line_buffer dut (
        .wclk_i(clk_i), .we_i(we_i), .windex_i(windex_i), .wdata_i(wdata_i),
        .rclk_i(clk_i), .re_i(1'b1), .rindex_i(place), .rdata_o(rdata)
    );
    line_buffer other (
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
endmodule

`default_nettype wire
