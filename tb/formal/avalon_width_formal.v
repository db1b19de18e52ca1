// avalon_width_formal.v - every byte of a command comes to the slave, and back to its place
//
// A master of 32 bits with a slave of 8, and one of 8 bits with a slave of 32, with two answers on
// their way at most.  A master keeps its command until it is taken.  By 1-step induction.

`default_nettype none

module avalon_width_formal (
    input wire        clk_i,
    input wire        rst_i,

    input wire        valid_i,
    input wire        write_i,
    input wire [29:0] word_i,         // the address, in words
    input wire [31:0] wdata_i,
    input wire [3:0]  be_i,
    input wire        ready_i,
    input wire        rvalid_i,
    input wire [7:0]  rdata_i,

    input wire        byte_valid_i,
    input wire        byte_write_i,
    input wire [31:0] byte_address_i,
    input wire [7:0]  byte_wdata_i,
    input wire        byte_be_i,
    input wire        byte_ready_i,
    input wire        byte_rvalid_i,
    input wire [31:0] byte_rdata_i
);
    wire        ready, rvalid, valid, write, be;
    wire [15:0] count, byte_count;
    wire [31:0] rdata, address;
    wire [7:0]  wdata;

    de1sim_avalon_width #(.FROM(32), .TO(8), .MOST_LOG2(1)) dut (
        .clk_i(clk_i), .rst_i(rst_i), .valid_i(valid_i), .ready_o(ready), .write_i(write_i),
        .count_i(16'd1), .count_o(count),
        .address_i({word_i, 2'd0}), .wdata_i(wdata_i), .be_i(be_i), .rvalid_o(rvalid),
        .rdata_o(rdata), .valid_o(valid), .ready_i(ready_i), .write_o(write), .address_o(address),
        .wdata_o(wdata), .be_o(be), .rvalid_i(rvalid_i), .rdata_i(rdata_i)
    );

    wire        byte_ready, byte_rvalid, byte_valid, byte_write;
    wire [31:0] byte_address, byte_wdata;
    wire [7:0]  byte_rdata;
    wire [3:0]  byte_be;

    de1sim_avalon_width #(.FROM(8), .TO(32), .MOST_LOG2(1)) wide (
        .clk_i(clk_i), .rst_i(rst_i), .valid_i(byte_valid_i), .ready_o(byte_ready),
        .write_i(byte_write_i), .count_i(16'd1), .count_o(byte_count),
        .address_i(byte_address_i), .wdata_i(byte_wdata_i),
        .be_i(byte_be_i), .rvalid_o(byte_rvalid), .rdata_o(byte_rdata), .valid_o(byte_valid),
        .ready_i(byte_ready_i), .write_o(byte_write), .address_o(byte_address),
        .wdata_o(byte_wdata), .be_o(byte_be), .rvalid_i(byte_rvalid_i), .rdata_i(byte_rdata_i)
    );

    // ---- The reference of the 32 bits: parts that were sent, and those on their way ----
    reg         live = 1'b0;
    reg  [3:0]  sent_q;
    reg  [2:0]  oldest_q, second_q;             // a part, and whether it is its command's last
    reg  [1:0]  owed_q;
    reg  [31:0] got_q;                          // of the command that is being answered
    reg         offered_q;
    reg  [1:0]  part_was;
    wire        taken = valid && ready_i;
    wire [1:0]  part  = address[1:0];
    wire [3:0]  wants = be_i == 4'd0 ? 4'd1 : be_i;
    wire [3:0]  after = sent_q | 4'd1 << part;
    wire [31:0] with_this = (got_q & ~(32'hff << {oldest_q[1:0], 3'd0}))
                            | {24'd0, rdata_i} << {oldest_q[1:0], 3'd0};

    // ---- The reference of the 8 bits ----
    reg  [1:0]  byte_oldest_q, byte_second_q, byte_owed_q;
    wire        byte_taken = byte_valid && byte_ready_i;

    // ---- A master's command stays ----
    reg         waits_q, byte_waits_q;
    reg  [66:0] command_q;
    reg  [41:0] byte_command_q;
    wire [66:0] command      = {write_i, word_i, wdata_i, be_i};
    wire [41:0] byte_command = {byte_write_i, byte_address_i, byte_wdata_i, byte_be_i};

    always @(posedge clk_i) begin
        live <= 1'b1;
        if (taken) sent_q <= ready ? 4'd0 : after;
        if (rvalid_i) begin
            oldest_q <= second_q;
            got_q    <= oldest_q[2] ? 32'd0 : with_this;
        end
        if (taken && owed_q - {1'b0, rvalid_i} == 2'd0) oldest_q <= {after == wants, part};
        if (taken && owed_q - {1'b0, rvalid_i} == 2'd1) second_q <= {after == wants, part};
        owed_q    <= owed_q + {1'b0, taken} - {1'b0, rvalid_i};
        offered_q <= valid && !ready_i;
        part_was  <= part;

        if (byte_rvalid_i) byte_oldest_q <= byte_second_q;
        if (byte_taken && byte_owed_q - {1'b0, byte_rvalid_i} == 2'd0)
            byte_oldest_q <= byte_address_i[1:0];
        if (byte_taken && byte_owed_q - {1'b0, byte_rvalid_i} == 2'd1)
            byte_second_q <= byte_address_i[1:0];
        byte_owed_q <= byte_owed_q + {1'b0, byte_taken} - {1'b0, byte_rvalid_i};

        waits_q      <= valid_i && !ready;
        byte_waits_q <= byte_valid_i && !byte_ready;
        {command_q, byte_command_q} <= {command, byte_command};
        if (rst_i) begin
            {sent_q, owed_q, byte_owed_q}      <= 8'd0;
            {offered_q, waits_q, byte_waits_q} <= 3'd0;
            got_q                              <= 32'd0;
        end
    end

    always @(*) begin
        if (!live) assume (rst_i);
        if (owed_q == 2'd0) assume (!rvalid_i);
        if (byte_owed_q == 2'd0) assume (!byte_rvalid_i);
        if (waits_q) assume (valid_i && command == command_q);
        if (byte_waits_q) assume (byte_valid_i && byte_command == byte_command_q);
    end

    // ---- What must hold ----
    always @(*) if (live) begin
        if (valid) begin
            a_part_of_it:   assert (valid_i && write == write_i && address[31:2] == word_i);
            a_part_is_open: assert ((wants >> part & 4'd1) != 4'd0
                                    && (sent_q >> part & 4'd1) == 4'd0);
            a_lowest_first: assert ((wants & ~sent_q & ((4'd1 << part) - 4'd1)) == 4'd0);
            a_byte:         assert (wdata == wdata_i[8*part +: 8] && be == be_i[part]);
            a_every_part:   assert (ready == (ready_i && after == wants));
        end
        if (!valid) a_not_taken: assert (!ready);
        if (valid_i && owed_q != 2'd2) a_offers: assert (valid);
        if (offered_q) a_stable: assert (valid && part == part_was);
        a_one_answer: assert (rvalid == (rvalid_i && oldest_q[2]));
        if (rvalid) a_data: assert (rdata == with_this);
        a_at_most: assert (owed_q != 2'd3 && byte_owed_q != 2'd3);

        a_wide_offers:  assert (byte_valid == (byte_valid_i && byte_owed_q != 2'd2));
        a_wide_taken:   assert (byte_ready == (byte_valid && byte_ready_i));
        a_wide_place:   assert (byte_address == {byte_address_i[31:2], 2'd0}
                                && byte_write == byte_write_i
                                && byte_be == {3'd0, byte_be_i} << byte_address_i[1:0]);
        a_wide_byte:    assert (byte_wdata[8*byte_address_i[1:0] +: 8] == byte_wdata_i);
        a_wide_answers: assert (byte_rvalid == byte_rvalid_i);
        if (byte_rvalid) a_wide_data: assert (byte_rdata == byte_rdata_i[8*byte_oldest_q +: 8]);
    end

    // ---- Invariants ----
    wire [3:0]  dut__narrower__done_q, wide__wider__be_q;
    wire        wide__wider__sent_q, dut__narrower__inside_q;
    wire [1:0]  wide__wider__stored_q;
    wire        wide__wider__free_q__0, wide__wider__free_q__1, wide__lasts_q__0, wide__lasts_q__1;
    wire        wide_oldest = byte_owed_q != 2'd0, wide_second = byte_owed_q == 2'd2;
    // Answers that are not the slave's, or not for the only part.
    wire [1:0]  wide_odd = {wide__wider__free_q__1 || !wide__lasts_q__1,
                            wide__wider__free_q__0 || !wide__lasts_q__0};
    wire [1:0]  wide_owned_free = {wide_odd[~wide__first_q] && wide_second,
                                   wide_odd[wide__first_q] && wide_oldest};
    wire [31:0] dut__narrower__rdata_q;
    wire [1:0]  dut__pending_q, wide__pending_q;
    wire        dut__first_q, dut__end_q, wide__first_q, wide__end_q;
    wire [7:0]  dut__parts_q__0, dut__parts_q__1, wide__parts_q__0, wide__parts_q__1;
    wire        dut__lasts_q__0, dut__lasts_q__1;

    wire [8:0] head   = dut__first_q ? {dut__lasts_q__1, dut__parts_q__1}
                                     : {dut__lasts_q__0, dut__parts_q__0};
    wire [8:0] second = dut__first_q ? {dut__lasts_q__0, dut__parts_q__0}
                                     : {dut__lasts_q__1, dut__parts_q__1};
    wire [7:0] wide_head   = wide__first_q ? wide__parts_q__1 : wide__parts_q__0;
    wire [7:0] wide_behind = wide__first_q ? wide__parts_q__0 : wide__parts_q__1;

    always @(*) if (live) begin
        i_alone:  assert (!wide__wider__sent_q && wide__wider__be_q == 4'd0
                          && wide__wider__stored_q == 2'd0 && !dut__narrower__inside_q);
        i_no_free: assert (wide_owned_free == 2'd0);
        i_done:   assert (dut__narrower__done_q == sent_q);
        i_rdata:  assert (dut__narrower__rdata_q == got_q);
        i_owed:   assert (dut__pending_q == owed_q && wide__pending_q == byte_owed_q);
        i_ends:   assert (dut__end_q == (dut__first_q ^ owed_q[0])
                          && wide__end_q == (wide__first_q ^ byte_owed_q[0]));
        if (owed_q != 2'd0) i_head: assert (head == {oldest_q[2], 6'd0, oldest_q[1:0]});
        if (owed_q == 2'd2) i_behind: assert (second == {second_q[2], 6'd0, second_q[1:0]});
        if (byte_owed_q != 2'd0) i_wide_head: assert (wide_head == {6'd0, byte_oldest_q});
        if (byte_owed_q == 2'd2) i_wide_behind: assert (wide_behind == {6'd0, byte_second_q});
        i_sent:   assert ((sent_q & ~wants) == 4'd0 && (sent_q == 4'd0 || waits_q)
                          && sent_q != wants);
        if (offered_q) i_offered: assert (waits_q && owed_q != 2'd2);
    end
endmodule

`default_nettype wire
