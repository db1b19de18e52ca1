// avalon_decoder_formal.v - each command goes to its slave, and its answer comes back, in order
//
// Three slaves, each with its count of commands without an answer.  A slave answers only what it
// was asked, in a later clock, and in order.  So order among slaves is kept if only one of them has
// a command that is not answered.  A burst goes to the slave of its first word.  By 1-step
// induction.

`default_nettype none

module avalon_decoder_formal (
    input wire        clk_i,
    input wire        rst_i,
    input wire        valid_i,
    input wire [15:0] count_i,
    input wire [2:0]  hit_i,
    input wire [2:0]  ready_i,
    input wire [2:0]  rvalid_i,
    input wire [11:0] rdata_i
);
    wire       ready, rvalid;
    wire [3:0] rdata;
    wire [2:0] valid;

    de1sim_avalon_decoder #(.SLAVES(3), .WIDTH(4)) dut (
        .clk_i(clk_i), .rst_i(rst_i), .valid_i(valid_i), .ready_o(ready),
        .count_i(count_i), .hit_i(hit_i), .rvalid_o(rvalid), .rdata_o(rdata), .valid_o(valid),
        .ready_i(ready_i), .rvalid_i(rvalid_i), .rdata_i(rdata_i)
    );

    // ---- The reference: commands that each slave has not answered ----
    reg        live = 1'b0;
    reg        waits_q;                        // a command that was not taken
    reg        inside_q;                       // a burst has begun, and has not ended
    reg  [2:0] last_q;                         // the slave of the last command
    reg  [2:0] hit_was, to_was, offered_q;
    reg [15:0] count_was;
    reg  [7:0] first_q, second_q, third_q;
    wire [2:0] takes = valid & ready_i;
    wire [2:0] to    = inside_q ? last_q : hit_i;

    always @(posedge clk_i) begin
        live      <= 1'b1;
        waits_q   <= valid_i && !ready && !rst_i;
        hit_was   <= hit_i;
        to_was    <= to;
        count_was <= count_i;
        if (takes != 3'd0) last_q <= to;
        if (takes != 3'd0) inside_q <= count_i != 16'd1;
        if (rst_i) inside_q <= 1'b0;
        offered_q <= rst_i ? 3'd0 : valid & ~ready_i;
        first_q   <= rst_i ? 8'd0 : first_q + {7'd0, takes[0]} - {7'd0, rvalid_i[0]};
        second_q  <= rst_i ? 8'd0 : second_q + {7'd0, takes[1]} - {7'd0, rvalid_i[1]};
        third_q   <= rst_i ? 8'd0 : third_q + {7'd0, takes[2]} - {7'd0, rvalid_i[2]};
    end

    wire [2:0] owes = {third_q != 8'd0, second_q != 8'd0, first_q != 8'd0};
    wire [7:0] sum  = first_q + second_q + third_q;

    always @(*) begin
        if (!live) assume (rst_i);
        assume (hit_i == 3'b001 || hit_i == 3'b010 || hit_i == 3'b100);
        assume ((rvalid_i & ~owes) == 3'd0);
        if (waits_q) assume (valid_i && hit_i == hit_was && count_i == count_was);
    end

    // ---- What must hold ----
    always @(*) if (live) begin
        a_to_its_slave: assert ((valid & ~to) == 3'd0 && (valid_i || valid == 3'd0));
        a_taken_once:   assert ((valid_i && ready) == (takes != 3'd0));
        a_in_order:     assert ((owes & (owes - 3'd1)) == 3'd0);
        if (sum == 8'd0 && valid_i) a_never_stuck: assert (valid == to);
        if (owes == to && sum < 8'd128 && valid_i) a_pipelined: assert (valid == to);
        a_at_most_128:  assert (sum <= 8'd128);
        a_stable:       assert ((offered_q & ~valid) == 3'd0);
        a_answers:      assert (rvalid == (rvalid_i != 3'd0));
        if (rvalid) a_data: assert (rdata == (rvalid_i[0] ? rdata_i[3:0]
                                              : rvalid_i[1] ? rdata_i[7:4] : rdata_i[11:8]));
    end

    // ---- Invariants ----
    wire [2:0] dut__slave_q;
    wire [7:0] dut__pending_q;
    wire       dut__goes_on_q;

    always @(*) if (live) begin
        i_inside:  assert (dut__goes_on_q == inside_q);
        if (inside_q || owes != 3'd0) i_last: assert (dut__slave_q == last_q);
        if (inside_q) i_one: assert (last_q == 3'b001 || last_q == 3'b010 || last_q == 3'b100);
        if (waits_q) i_to: assert (to_was == (inside_q ? last_q : hit_was));
        i_pending: assert (dut__pending_q == sum);
        i_slave:   assert (owes == 3'd0 || owes == dut__slave_q);
        i_first:   assert (first_q <= 8'd128 && second_q <= 8'd128 && third_q <= 8'd128);
        if (offered_q != 3'd0) i_offered: assert (waits_q && offered_q == to_was
                                                  && (owes == 3'd0 || owes == offered_q)
                                                  && (sum != 8'd128));
    end
endmodule

`default_nettype wire
