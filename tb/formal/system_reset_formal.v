// system_reset_formal.v - a system's reset begins at once and ends with its clock, for any clock
//
// The clock and the reset may change at any time.  By 6-step induction.

`default_nettype none

module system_reset_formal (
    input wire clk_i,
    input wire rst_i
);
    wire rst;

    de1sim_reset dut (.clk_i(clk_i), .rst_i(rst_i), .rst_o(rst));

    // ---- The reference: edges of the clock since the reset ended, two at most ----
    reg       live = 1'b0, clk_was, rst_was, rst_o_was;
    reg [1:0] edges_q = 2'd0;

    always @(posedge clk_i or posedge rst_i)
        if (rst_i) edges_q <= 2'd0;
        else if (edges_q != 2'd2) edges_q <= edges_q + 2'd1;

    always @($global_clock) begin
        live      <= 1'b1;
        clk_was   <= clk_i;
        rst_was   <= rst_i;
        rst_o_was <= rst;
    end

    // ---- What must hold ----
    always @(*) begin
        if (rst_i) a_begins_at_once: assert (rst);
        if (edges_q != 2'd2) a_lasts_two_edges: assert (rst);
        if (edges_q == 2'd2) a_ends: assert (!rst);
        if (live && !rst && rst_o_was) a_ends_with_the_clock: assert (clk_i && !clk_was);
    end

    // ---- Invariant ----
    wire [1:0] dut__line_q;
    always @(*) i_line: assert (dut__line_q == (edges_q == 2'd0 ? 2'b11
                                                : edges_q == 2'd1 ? 2'b10 : 2'b00));
endmodule

`default_nettype wire
