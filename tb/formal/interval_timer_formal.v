// interval_timer_formal.v - the interrupt is high exactly while an end is not cleared and enabled,
// and every register reads what it should, snapshots of the running counter too.
//
// By 2-step induction, against a reference that counts the four ticks of a clock one by one, as in
// the manual.  Writes of whole half words are free, at any time; periods are four ticks or more.

`default_nettype none

module interval_timer_formal (
    input wire        clk_i,
    input wire        rst_i,
    input wire        we_i,
    input wire [11:0] waddr_i,
    input wire [31:0] wdata_i,
    input wire        re_i,
    input wire [11:0] raddr_i
);
    wire        irq;
    wire [31:0] rdata;

    interval_timer dut (
        .clk_i(clk_i), .rst_i(rst_i), .we_i(we_i), .wstrb_i(4'b1111),
        .waddr_i(waddr_i), .raddr_i(raddr_i), .wdata_i(wdata_i), .re_i(re_i), .rdata_o(rdata),
        .irq_o(irq)
    );

    // ---- The reference: a tick at a time ----
    reg         live = 1'b0, known_q = 1'b0;  // known: reset before the last clock
    reg  [31:0] period_q, counter_q, counter, snap_q, read_q;
    reg  [3:0]  control_q;                     // STOP, START, CONT, ITO
    reg         to_q, run_q, to, run;
    wire [4:0]  register = waddr_i[4:0];
    integer     tick;

    always @(*) begin
        {counter, to, run} = {counter_q, to_q, run_q};
        for (tick = 0; tick < 4; tick = tick + 1)
            if (run) begin
                if (counter == 32'd0) begin
                    counter = period_q;
                    to      = 1'b1;
                    run     = control_q[1];
                end else begin
                    counter = counter - 32'd1;
                end
            end
    end

    always @(posedge clk_i) begin
        live    <= 1'b1;
        known_q <= live;
        {counter_q, to_q, run_q} <= {counter, to, run};
        if (we_i) case (register)
            5'h00: to_q <= 1'b0;
            5'h04: begin
                control_q <= wdata_i[3:0];
                run_q     <= wdata_i[2] || (run && !wdata_i[3]);
            end
            5'h08: begin
                period_q[15:0] <= wdata_i[15:0];
                counter_q      <= {period_q[31:16], wdata_i[15:0]};
                run_q          <= 1'b0;
            end
            5'h0c: begin
                period_q[31:16] <= wdata_i[15:0];
                counter_q       <= {wdata_i[15:0], period_q[15:0]};
                run_q           <= 1'b0;
            end
            5'h10, 5'h14: snap_q <= counter_q;
            default: ;
        endcase
        read_q <= 32'd0;
        if (re_i) case (raddr_i[4:0])
            5'h00: read_q[1:0]  <= {run_q, to_q};
            5'h04: read_q[3:0]  <= control_q;
            5'h08: read_q[15:0] <= period_q[15:0];
            5'h0c: read_q[15:0] <= period_q[31:16];
            5'h10: read_q[15:0] <= snap_q[15:0];
            5'h14: read_q[15:0] <= snap_q[31:16];
            default: ;
        endcase
        if (rst_i) begin
            snap_q    <= 32'd0;
            period_q  <= 32'd12_499_999;   // 125 ms
            counter_q <= 32'd12_499_999;
            {to_q, run_q, control_q} <= 6'd0;
        end
    end
    always @(*) if (!live) assume (rst_i);
    always @(*) if (live) assume (period_q >= 32'd3);

    // ---- What must hold, and the invariants ----
    wire [31:0] dut__period_q, dut__snap_q;
    wire [31:0] dut__counter_q;
    wire [3:0]  dut__control_q;
    wire        dut__to_q, dut__run_q;

    always @(*) if (live) begin
        a_irq: assert (irq == (to_q && control_q[0]));
        if (known_q) a_reads: assert (rdata == read_q);
        i_period: assert (dut__period_q == period_q);
        i_counter: assert (dut__counter_q == counter_q && counter_q <= period_q);
        i_snap: assert (dut__snap_q == snap_q);
        i_flags: assert ({dut__to_q, dut__run_q, dut__control_q} == {to_q, run_q, control_q});
    end
endmodule

`default_nettype wire
