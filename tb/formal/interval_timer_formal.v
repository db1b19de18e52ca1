// interval_timer_formal.v - the interrupt is high exactly while an end that was not cleared counts.
//
// By 2-step induction, against a counter that takes the four ticks of a clock one by one, as the
// manual tells it.  Every write, at any time, of whole half words; periods of four ticks or more.

`default_nettype none

module interval_timer_formal (
    input wire        clk_i,
    input wire        rst_i,
    input wire        we_i,
    input wire [11:0] waddr_i,
    input wire [31:0] wdata_i
);
    wire irq;

    interval_timer dut (
        .clk_i(clk_i), .rst_i(rst_i), .we_i(we_i), .wstrb_i(4'b1111), .waddr_i(waddr_i),
        .raddr_i(12'd0), .wdata_i(wdata_i), .re_i(1'b0), .rdata_o(), .irq_o(irq)
    );

    // ---- The reference: a tick at a time ----
    reg         live = 1'b0;
    reg  [31:0] period_q, counter_q, counter;
    reg         to_q, run_q, ito_q, cont_q, to, run;
    wire [4:0]  register = waddr_i[4:0];
    integer     tick;

    always @(*) begin
        {counter, to, run} = {counter_q, to_q, run_q};
        for (tick = 0; tick < 4; tick = tick + 1)
            if (run) begin
                if (counter == 32'd0) begin
                    counter = period_q;
                    to      = 1'b1;
                    run     = cont_q;
                end else begin
                    counter = counter - 32'd1;
                end
            end
    end

    always @(posedge clk_i) begin
        live <= 1'b1;
        {counter_q, to_q, run_q} <= {counter, to, run};
        if (we_i) case (register)
            5'h00: to_q <= 1'b0;
            5'h04: begin
                {cont_q, ito_q} <= wdata_i[1:0];
                run_q <= wdata_i[2] || (run && !wdata_i[3]);
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
            default: ;
        endcase
        if (rst_i) begin
            period_q  <= 32'd12_499_999;   // 125 ms
            counter_q <= 32'd12_499_999;
            {to_q, run_q, ito_q, cont_q} <= 4'd0;
        end
    end
    always @(*) if (!live) assume (rst_i);
    always @(*) if (live) assume (period_q >= 32'd3);

    // ---- What must hold, and the invariants ----
    wire [31:0] dut__period_q, dut__counter_q;
    wire        dut__to_q, dut__run_q, dut__ito_q, dut__cont_q;

    always @(*) if (live) begin
        a_irq: assert (irq == (to_q && ito_q));
        i_period: assert (dut__period_q == period_q);
        i_counter: assert (dut__counter_q == counter_q && counter_q <= period_q);
        i_flags: assert ({dut__to_q, dut__run_q, dut__ito_q, dut__cont_q}
                         == {to_q, run_q, ito_q, cont_q});
    end
endmodule

`default_nettype wire
