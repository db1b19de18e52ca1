// avalon_arbiter_formal.v - one master at a time, each in its turn, and each has its own answers
//
// Three masters with 1, 2 and 3 shares, four answers on their way at most, from power-on, with or
// without a reset.  A master keeps its command until it is taken.  Of two with bursts nobody comes
// between the words of one.  By 1-step induction.

`default_nettype none

module avalon_arbiter_formal (
    input wire        clk_i,
    input wire        rst_i,
    input wire [2:0]  valid_i,
    input wire [2:0]  write_i,
    input wire [95:0] address_i,
    input wire [23:0] wdata_i,
    input wire [2:0]  be_i,
    input wire [31:0] count_i,        // of the two with bursts
    input wire        ready_i,
    input wire        rvalid_i
);
    wire [2:0]  ready, rvalid;
    wire        valid, write, be;
    wire [31:0] address;
    wire [7:0]  wdata;

    de1sim_avalon_arbiter #(
        .MASTERS(3), .WIDTH(8), .SHARES({8'd3, 8'd2, 8'd1}), .MOST_LOG2(2)
    ) dut (
        .clk_i(clk_i), .rst_i(rst_i), .valid_i(valid_i), .ready_o(ready), .write_i(write_i),
        .count_i({3{16'd1}}), .address_i(address_i), .wdata_i(wdata_i), .be_i(be_i),
        .rvalid_o(rvalid), .valid_o(valid), .ready_i(ready_i), .write_o(write), .count_o(count),
        .address_o(address), .wdata_o(wdata), .be_o(be), .rvalid_i(rvalid_i)
    );

    wire [1:0]  burst_ready, burst_rvalid;
    wire        burst_valid, burst_write, burst_be;
    wire [15:0] count, burst_count;
    wire [31:0] burst_address;
    wire [7:0]  burst_wdata;

    de1sim_avalon_arbiter #(.MASTERS(2), .WIDTH(8), .MOST_LOG2(2)) bursts (
        .clk_i(clk_i), .rst_i(rst_i), .valid_i(valid_i[1:0]), .ready_o(burst_ready),
        .write_i(write_i[1:0]), .count_i(count_i), .address_i(address_i[63:0]),
        .wdata_i(wdata_i[15:0]), .be_i(be_i[1:0]), .rvalid_o(burst_rvalid),
        .valid_o(burst_valid), .ready_i(ready_i), .write_o(burst_write), .count_o(burst_count),
        .address_o(burst_address), .wdata_o(burst_wdata), .be_o(burst_be), .rvalid_i(rvalid_i)
    );
    reg         inside_q = 1'b0, owner_q = 1'b0;
    wire [1:0]  burst_takes = valid_i[1:0] & burst_ready;
    wire        bursts__inside_q;
    wire [7:0]  bursts__turn_q;

    always @(posedge clk_i) begin
        if (burst_takes != 2'd0) begin
            inside_q <= burst_count != 16'd1;
            owner_q  <= burst_takes[1];
        end
        if (rst_i) inside_q <= 1'b0;
    end
    always @(*) begin
        a_nobody_between: assert (!inside_q || (burst_takes & ~(2'd1 << owner_q)) == 2'd0);
        a_burst_of_one:   assert (burst_takes != 2'd3);
        if (burst_takes != 2'd0)
            a_count: assert (burst_count == count_i[16*burst_takes[1] +: 16]);
        i_inside: assert (bursts__inside_q == inside_q);
        i_owner:  assert (!inside_q || bursts__turn_q == {7'd0, owner_q});
        i_one_of: assert (bursts__turn_q < 8'd2);
    end

    function [1:0] shares;
        input [1:0] master;
        shares = master + 2'd1;
    endfunction

    // ---- The reference ----
    wire [7:0] dut__turn;
    wire [1:0] turn = dut__turn[1:0];    // who has the slave in this clock, if it is asked at all
    wire       taken = valid && ready_i;

    reg        offered_q = 1'b0;         // a command that the slave has not taken
    reg  [7:0] owners_q;                 // of the answers on their way, the oldest in bits 1:0
    reg  [2:0] owed_q = 3'd0;            // answers on their way
    reg  [1:0] who_q = 2'd0, run_q = 2'd1; // whose turn it was last, and its commands in this turn
    reg  [2:0] waits_q = 3'd0;           // masters whose command was not taken
    reg  [2:0] write_was, be_was;
    reg [95:0] address_was;
    reg [23:0] wdata_was;
    reg  [3:0] waited_q [0:2];           // commands of others since a master began to wait
    wire [2:0] left = owed_q - {2'd0, rvalid_i};
    wire       new_turn = turn != who_q || run_q == shares(who_q);

    integer n;
    initial for (n = 0; n < 3; n = n + 1) waited_q[n] = 4'd0;
    always @(posedge clk_i) begin
        offered_q <= valid && !ready_i && !rst_i;
        if (rvalid_i) owners_q <= owners_q >> 2;
        if (taken) owners_q[2 * left[1:0] +: 2] <= turn;
        owed_q <= left + {2'd0, taken};
        if (valid) begin
            who_q <= turn;
            run_q <= {1'b0, taken} + (new_turn ? 2'd0 : run_q);
        end
        waits_q <= valid_i & ~ready;
        {write_was, address_was, wdata_was, be_was} <= {write_i, address_i, wdata_i, be_i};
        for (n = 0; n < 3; n = n + 1)
            waited_q[n] <= !valid_i[n] || ready[n] ? 4'd0
                           : waited_q[n] + {3'd0, taken && turn != n[1:0]};
        if (rst_i) begin
            owed_q  <= 3'd0;
            waits_q <= 3'd0;
            run_q   <= valid ? shares(turn) : shares(who_q);
            for (n = 0; n < 3; n = n + 1) waited_q[n] <= 4'd0;
        end
    end

    always @(*) if (owed_q == 3'd0) assume (!rvalid_i);

    wire [2:0] asked = 3'd1 << turn;
    genvar m;
    generate
        for (m = 0; m < 3; m = m + 1) begin : master
            always @(*) if (waits_q[m])
                assume (valid_i[m] && write_i[m] == write_was[m] && be_i[m] == be_was[m]
                        && address_i[32*m +: 32] == address_was[32*m +: 32]
                        && wdata_i[8*m +: 8] == wdata_was[8*m +: 8]);
        end
    endgenerate

    // ---- What must hold ----
    always @(*) begin
        a_one:     assert ((ready & valid_i) == (taken ? asked : 3'd0));
        a_asked:   assert (!valid || (valid_i & asked) != 3'd0);
        if (valid) a_command: assert (write == write_i[turn] && be == be_i[turn]
                                      && address == address_i[32*turn +: 32]
                                      && wdata == wdata_i[8*turn +: 8]);
        if (valid_i != 3'd0 && owed_q != 3'd4) a_offers: assert (valid);
        a_at_most: assert (owed_q <= 3'd4);
        if (offered_q) a_stable: assert (valid && turn == who_q);
        a_answers: assert (rvalid == (rvalid_i ? 3'd1 << owners_q[1:0] : 3'd0));
        if (valid && turn != who_q)
            a_keeps_its_turn: assert (!valid_i[who_q] || run_q == shares(who_q));
        if (valid && turn == who_q && run_q == shares(who_q))
            a_gives_its_turn: assert ((valid_i & ~asked) == 3'd0);
        a_waits: assert (waited_q[0] <= 4'd5 && waited_q[1] <= 4'd4 && waited_q[2] <= 4'd3);
    end

    // ---- Invariants ----
    wire [7:0] dut__turn_q, dut__left_q;
    wire [2:0] dut__pending_q;
    wire [1:0] dut__first_q, dut__end_q;
    wire [7:0] dut__owners_q__0, dut__owners_q__1, dut__owners_q__2, dut__owners_q__3;

    // Commands of others until the master has its turn, if all of them ask.
    function [3:0] until_turn;
        input [1:0] of;
        case ({who_q, of})
            4'b00_00: until_turn = dut__left_q != 8'd0 ? 4'd0 : 4'd5;
            4'b01_00: until_turn = dut__left_q[3:0] + 4'd3;
            4'b10_00: until_turn = dut__left_q[3:0];
            4'b00_01: until_turn = dut__left_q[3:0];
            4'b01_01: until_turn = dut__left_q != 8'd0 ? 4'd0 : 4'd4;
            4'b10_01: until_turn = dut__left_q[3:0] + 4'd1;
            4'b00_10: until_turn = dut__left_q[3:0] + 4'd2;
            4'b01_10: until_turn = dut__left_q[3:0];
            default:  until_turn = dut__left_q != 8'd0 ? 4'd0 : 4'd3;
        endcase
    endfunction

    // The oldest in bits 7:0.
    wire [63:0] twice  = {2{dut__owners_q__3, dut__owners_q__2, dut__owners_q__1,
                            dut__owners_q__0}};
    wire [31:0] owners = twice[8 * dut__first_q +: 32];
    wire  [3:0] right;
    generate
        for (m = 0; m < 4; m = m + 1) begin : answer
            assign right[m] = owed_q <= m || (owners_q[2*m +: 2] != 2'd3
                              && owners[8*m +: 8] == {6'd0, owners_q[2*m +: 2]});
        end
    endgenerate

    wire       dut__inside_q;
    always @(*) i_alone: assert (!dut__inside_q);
    always @(*) i_turn: assert (dut__turn_q == {6'd0, who_q} && who_q != 2'd3);
    always @(*) begin
        i_pending: assert (dut__pending_q == owed_q);
        i_end:     assert (dut__end_q == (dut__first_q + owed_q[1:0]));
        i_owners:  assert (right == 4'b1111);
        i_left:    assert (dut__left_q == {6'd0, shares(who_q)} - {6'd0, run_q}
                           && run_q <= shares(who_q));
        if (offered_q) i_offered: assert (waits_q[who_q] && dut__left_q != 8'd0 && owed_q != 3'd4);
        i_waited0: assert (waited_q[0] + until_turn(2'd0) <= 4'd5 || waited_q[0] == 4'd0);
        i_waited1: assert (waited_q[1] + until_turn(2'd1) <= 4'd4 || waited_q[1] == 4'd0);
        i_waited2: assert (waited_q[2] + until_turn(2'd2) <= 4'd3 || waited_q[2] == 4'd0);
        i_waits:   assert ((waits_q[0] || waited_q[0] == 4'd0)
                           && (waits_q[1] || waited_q[1] == 4'd0)
                           && (waits_q[2] || waited_q[2] == 4'd0));
    end
endmodule

`default_nettype wire
