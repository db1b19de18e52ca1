// interval_timer_twin_formal.v - sim/fpga/interval_timer.v counts as the one in rtl/timer does
//
// By induction, from any count; accesses and resets are unconstrained, and so are periods.

`default_nettype none

module interval_timer_twin_formal (
    input wire        clk_i,
    input wire        rst_i,
    input wire        we_i,
    input wire [3:0]  wstrb_i,
    input wire [11:0] waddr_i,
    input wire [31:0] wdata_i,
    input wire        re_i,
    input wire [11:0] raddr_i
);
    wire [31:0] plain_rdata, twin_rdata;
    wire        plain_irq, twin_irq;

    interval_timer plain (
        .clk_i(clk_i), .rst_i(rst_i), .we_i(we_i), .wstrb_i(wstrb_i), .waddr_i(waddr_i),
        .raddr_i(raddr_i), .wdata_i(wdata_i), .re_i(re_i), .rdata_o(plain_rdata),
        .irq_o(plain_irq), .awake_o()
    );
    interval_timer_twin twin (
        .clk_i(clk_i), .rst_i(rst_i), .we_i(we_i), .wstrb_i(wstrb_i), .waddr_i(waddr_i),
        .raddr_i(raddr_i), .wdata_i(wdata_i), .re_i(re_i), .rdata_o(twin_rdata),
        .irq_o(twin_irq), .awake_o()
    );

    wire [29:0] twin__now, twin__due_q;
    wire [1:0]  twin__phase_q;
    wire [31:0] plain__counter_q, plain__period_q, twin__period_q, plain__snap_q, twin__snap_q;
    wire [3:0]  plain__control_q, twin__control_q;
    wire        plain__run_q, twin__run_q, plain__to_q, twin__to_q;
    wire        live;
    numbered_clocks clocks (.clk_i(clk_i), .now_i(twin__now), .live_o(live));
    reg         read_q = 1'b0;               // what is read was reset before
    always @(posedge clk_i) read_q <= live;
    always @(*) if (!live) assume (rst_i);

    wire [29:0] left = twin__run_q ? twin__due_q - twin__now : twin__due_q;
    always @(*) if (live) begin
        a_irq:     assert (twin_irq == plain_irq);
        if (read_q) a_reads: assert (twin_rdata == plain_rdata);
        i_counter: assert ({left, twin__phase_q} == plain__counter_q);
        i_period:  assert (twin__period_q == plain__period_q && twin__snap_q == plain__snap_q);
        i_flags:   assert ({twin__run_q, twin__to_q, twin__control_q}
                           == {plain__run_q, plain__to_q, plain__control_q});
    end
endmodule

`default_nettype wire
