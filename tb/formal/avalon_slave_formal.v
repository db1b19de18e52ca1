// avalon_slave_formal.v - a slave sees the timing that it has asked for, and is answered for once
//
// Three slaves: one with fixed waits, a setup and a hold time; one with waitrequest and
// readdatavalid; one that is pipelined with a latency of 2 and cannot be written.  The hold time of
// the last two does not count.  A master keeps its command until it is taken.  By 3-step induction.
//
// Source: Avalon Interface Specifications, Avalon Memory-Mapped Interfaces.

`default_nettype none

module avalon_slave_formal (
    input wire        clk_i,
    input wire        rst_i,
    input wire [2:0]  valid_i,        // fixed, waits, pipelined
    input wire [2:0]  write_i,
    input wire [95:0] address_i,
    input wire [47:0] wdata_i,
    input wire [5:0]  be_i,
    input wire [47:0] readdata_i,
    input wire        waitrequest_i,
    input wire        readdatavalid_i
);
    wire [2:0]  ready, rvalid, chipselect, read, write, begins;
    wire [47:0] rdata, writedata;
    wire [8:0]  address;
    wire [5:0]  byteenable;

    de1sim_avalon_slave #(
        .WIDTH(16), .ADDRESS(3), .SHIFT(1), .SETUP(1), .READ_WAIT(2), .WRITE_WAIT(1), .HOLD(1)
    ) fixed (
        .clk_i(clk_i), .rst_i(rst_i), .valid_i(valid_i[0]), .ready_o(ready[0]),
        .write_i(write_i[0]), .address_i(address_i[31:0]), .wdata_i(wdata_i[15:0]),
        .be_i(be_i[1:0]), .length_i(12'd1),
        .rvalid_o(rvalid[0]), .rdata_o(rdata[15:0]), .address_o(address[2:0]),
        .chipselect_o(chipselect[0]), .read_o(read[0]), .write_o(write[0]),
        .begintransfer_o(begins[0]), .byteenable_o(byteenable[1:0]),
        .writedata_o(writedata[15:0]), .readdata_i(readdata_i[15:0]), .waitrequest_i(1'b0),
        .readdatavalid_i(1'b0)
    );
    de1sim_avalon_slave #(
        .WIDTH(16), .ADDRESS(3), .SHIFT(0), .WAITREQUEST(1), .READDATAVALID(1), .HOLD(1)
    ) waits (
        .clk_i(clk_i), .rst_i(rst_i), .valid_i(valid_i[1]), .ready_o(ready[1]),
        .write_i(write_i[1]), .address_i(address_i[63:32]), .wdata_i(wdata_i[31:16]),
        .be_i(be_i[3:2]), .length_i(12'd1),
        .rvalid_o(rvalid[1]), .rdata_o(rdata[31:16]), .address_o(address[5:3]),
        .chipselect_o(chipselect[1]), .read_o(read[1]), .write_o(write[1]),
        .begintransfer_o(begins[1]), .byteenable_o(byteenable[3:2]),
        .writedata_o(writedata[31:16]), .readdata_i(readdata_i[31:16]),
        .waitrequest_i(waitrequest_i), .readdatavalid_i(readdatavalid_i)
    );
    de1sim_avalon_slave #(
        .WIDTH(16), .ADDRESS(3), .SHIFT(1), .READ_WAIT(0), .LATENCY(2), .WRITES(0), .HOLD(1)
    ) later (
        .clk_i(clk_i), .rst_i(rst_i), .valid_i(valid_i[2]), .ready_o(ready[2]),
        .write_i(write_i[2]), .address_i(address_i[95:64]), .wdata_i(wdata_i[47:32]),
        .be_i(be_i[5:4]), .length_i(12'd1),
        .rvalid_o(rvalid[2]), .rdata_o(rdata[47:32]), .address_o(address[8:6]),
        .chipselect_o(chipselect[2]), .read_o(read[2]), .write_o(write[2]),
        .begintransfer_o(begins[2]), .byteenable_o(byteenable[5:4]),
        .writedata_o(writedata[47:32]), .readdata_i(readdata_i[47:32]), .waitrequest_i(1'b0),
        .readdatavalid_i(1'b0)
    );

    // ---- A master's command stays ----
    reg         live = 1'b0;
    reg  [2:0]  stays_q;
    reg  [152:0] command_was;
    wire [152:0] command;
    wire [2:0]  passes;                // the command, where it is read or written
    genvar      m;
    generate
        for (m = 0; m < 3; m = m + 1) begin : master
            assign command[51*m +: 51] = {write_i[m], address_i[32*m +: 32],
                                          wdata_i[16*m +: 16], be_i[2*m +: 2]};
            always @(*) if (stays_q[m])
                assume (valid_i[m] && command[51*m +: 51] == command_was[51*m +: 51]);
            assign passes[m] = chipselect[m] && write[m] == write_i[m] && read[m] != write[m]
                               && address[3*m +: 3] == address_i[32*m + (m == 1 ? 0 : 1) +: 3]
                               && byteenable[2*m +: 2] == be_i[2*m +: 2]
                               && writedata[16*m +: 16] == wdata_i[16*m +: 16];
        end
    endgenerate

    // ---- The reference ----
    reg  [1:0]  age_q;                 // fixed: clocks of this transfer that are over
    reg         begun_q;               // waits: the transfer has begun
    reg  [7:0]  reads_q;               // reads without their data
    reg  [2:0]  later_q, later_read_q; // later: answers in one, two and three clocks; of reads
    reg  [1:0]  answer_q;              // fixed, waits: an answer is due, with these data
    reg  [47:0] answer_data_q;
    wire [2:0]  taken = valid_i & ready;
    wire        fixed_runs = valid_i[0] && !rst_i;

    always @(posedge clk_i) begin
        live        <= 1'b1;
        command_was <= command;
        stays_q <= valid_i & ~ready;
        age_q   <= fixed_runs && !ready[0] ? age_q + 2'd1 : 2'd0;
        begun_q <= chipselect[1] && !ready[1];
        reads_q <= reads_q + {7'd0, taken[1] && !write_i[1]} - {7'd0, readdatavalid_i};

        answer_q             <= {readdatavalid_i || taken[1] && write_i[1], taken[0]};
        answer_data_q[15:0]  <= write_i[0] ? 16'd0 : readdata_i[15:0];
        answer_data_q[31:16] <= readdatavalid_i ? readdata_i[31:16] : 16'd0;

        later_q              <= {later_q[1:0], taken[2]};
        later_read_q         <= {later_read_q[1:0], taken[2] && !write_i[2]};
        answer_data_q[47:32] <= later_read_q[1] ? readdata_i[47:32] : 16'd0;
        if (rst_i) begin
            {stays_q, age_q, begun_q, answer_q, later_q, later_read_q} <= 14'd0;
            reads_q                                                    <= 8'd0;
        end
    end

    always @(*) begin
        if (!live) assume (rst_i);
        if (reads_q == 8'd0) assume (!readdatavalid_i);
    end

    // ---- What must hold ----
    always @(*) if (live) begin
        a_command: assert ((~passes & (read | write)) == 3'd0);

        // Setup, three clocks of a read; setup, two of a write, hold.
        a_setup:      assert (chipselect[0] == fixed_runs
                              && begins[0] == (fixed_runs && age_q == 2'd0));
        a_read_wait:  assert (read[0] == (fixed_runs && !write_i[0] && age_q != 2'd0));
        a_write_hold: assert (write[0] == (fixed_runs && write_i[0]
                                           && (age_q == 2'd1 || age_q == 2'd2)));
        a_ends:       assert (taken[0] == (fixed_runs && age_q == 2'd3));
        a_answer:     assert (rvalid[0] == answer_q[0]);
        if (rvalid[0]) a_data: assert (rdata[15:0] == answer_data_q[15:0]);

        a_waits:      assert (taken[1] == (chipselect[1] && !waitrequest_i));
        if (chipselect[1]) a_asks: assert (read[1] == !write_i[1] && write[1] == write_i[1]);
        a_begins:     assert (begins[1] == (chipselect[1] && !begun_q));
        if (begun_q && !rst_i) a_stays: assert (chipselect[1]);
        a_reads_first: assert (!(write[1] && reads_q != 8'd0));
        if (valid_i[1] && !rst_i && (write_i[1] ? reads_q == 8'd0 : reads_q < 8'd128))
            a_never_stuck: assert (chipselect[1]);
        a_at_most:    assert (reads_q <= 8'd128);
        a_when_valid: assert (rvalid[1] == answer_q[1]);
        if (rvalid[1]) a_valid_data: assert (rdata[31:16] == answer_data_q[31:16]);

        a_pipelined:  assert (taken[2] == (valid_i[2] && !rst_i)
                              && read[2] == (taken[2] && !write_i[2]));
        a_not_written: assert (!write[2]);
        a_latency:    assert (rvalid[2] == later_q[2]);
        if (rvalid[2]) a_late_data: assert (rdata[47:32] == answer_data_q[47:32]);
    end

    // ---- Invariants ----
    wire       write_was = command_was[51 + 50];
    wire [7:0]  fixed__clock_q, waits__clock_q;
    wire [11:0] waits__pending_q;

    always @(*) if (live) begin
        i_age:     assert (fixed__clock_q == {6'd0, age_q});
        i_begun:   assert ((waits__clock_q != 8'd0) == begun_q);
        i_reads:   assert (waits__pending_q == {4'd0, reads_q});
        i_stays:   assert (!begun_q || (stays_q[1] && (write_was ? reads_q == 8'd0
                                                       : reads_q != 8'd128)));
        i_age_stays: assert (age_q == 2'd0 || stays_q[0]);
    end
endmodule

`default_nettype wire
