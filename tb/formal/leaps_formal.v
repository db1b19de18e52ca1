// leaps_formal.v - the modules of sim/fpga that leap over clocks equal those of rtl/ at their ports
//
// Countdown, prescaler, interval timer and beam, but for awake_o.  By induction, from any count;
// accesses, loads, resets and periods are unconstrained.

`default_nettype none

module leaps_formal (
    input wire        clk_i,
    input wire        rst_i,
    input wire        load_i,
    input wire [7:0]  value_i,
    input wire        run_i,
    input wire        we_i,
    input wire [3:0]  wstrb_i,
    input wire [11:0] waddr_i,
    input wire [31:0] wdata_i,
    input wire        re_i,
    input wire [11:0] raddr_i
);
    wire [8:0]  down, leapt_down;              // the count and whether it is 0
    wire        tick, leapt_tick;
    wire [31:0] rdata, leapt_rdata;
    wire        irq, leapt_irq;
    wire [34:0] pins, leapt_pins;

    countdown plaindown (
        .clk_i(clk_i), .load_i(load_i), .value_i(value_i), .run_i(run_i), .count_o(down[7:0]),
        .zero_o(down[8]), .awake_o()
    );
    countdown_twin twindown (
        .clk_i(clk_i), .load_i(load_i), .value_i(value_i), .run_i(run_i),
        .count_o(leapt_down[7:0]), .zero_o(leapt_down[8]), .awake_o()
    );
    prescaler plainticks (
        .clk_i(clk_i), .rst_i(rst_i), .wanted_i(1'b1), .tick_o(tick), .awake_o()
    );
    prescaler_twin twinticks (
        .clk_i(clk_i), .rst_i(rst_i), .wanted_i(1'b1), .tick_o(leapt_tick), .awake_o()
    );
    interval_timer plain (
        .clk_i(clk_i), .rst_i(rst_i), .we_i(we_i), .wstrb_i(wstrb_i), .waddr_i(waddr_i),
        .raddr_i(raddr_i), .wdata_i(wdata_i), .re_i(re_i), .rdata_o(rdata), .irq_o(irq), .awake_o()
    );
    interval_timer_twin twin (
        .clk_i(clk_i), .rst_i(rst_i), .we_i(we_i), .wstrb_i(wstrb_i), .waddr_i(waddr_i),
        .raddr_i(raddr_i), .wdata_i(wdata_i), .re_i(re_i), .rdata_o(leapt_rdata),
        .irq_o(leapt_irq), .awake_o()
    );
    vga_timing plainbeam (
        .clk_i(clk_i), .rst_i(rst_i), .h_o(pins[9:0]), .v_o(pins[19:10]), .v_next_o(pins[29:20]),
        .line_end_o(pins[30]), .visible_o(pins[31]), .hs_no(pins[32]), .vs_no(pins[33]),
        .blank_no(pins[34])
    );
    vga_timing_twin twinbeam (
        .clk_i(clk_i), .rst_i(rst_i), .h_o(leapt_pins[9:0]), .v_o(leapt_pins[19:10]),
        .v_next_o(leapt_pins[29:20]), .line_end_o(leapt_pins[30]), .visible_o(leapt_pins[31]),
        .hs_no(leapt_pins[32]), .vs_no(leapt_pins[33]), .blank_no(leapt_pins[34])
    );

    // ---- The numbers of the clocks ----
    wire [29:0] twindown__now, twinticks__now, twin__now, twinbeam__now;
    reg  [29:0] now_q;                         // of the first clock any
    reg         live = 1'b0, read_q = 1'b0;    // read_q: what is read was reset before
    always @(posedge clk_i) {now_q, live, read_q} <= {now_q + 30'd1, 1'b1, live};
    always @(*) begin
        assume ({twindown__now, twinticks__now, twin__now, twinbeam__now} == {4{now_q}});
        if (!live) assume (rst_i && load_i);
    end

    // ---- What must hold ----
    always @(*) if (live) begin
        a_count: assert (leapt_down == down);
        a_tick:  assert (leapt_tick == tick);
        a_irq:   assert (leapt_irq == irq);
        if (read_q) a_reads: assert (leapt_rdata == rdata);
        a_beam:  assert (leapt_pins == pins);
    end

    // ---- Invariants ----
    wire [4:0]  plainticks__count_q, twinticks__since;
    wire [29:0] twin__due_q;
    wire [1:0]  twin__phase_q;
    wire [31:0] plain__counter_q, plain__period_q, twin__period_q, plain__snap_q, twin__snap_q;
    wire [3:0]  plain__control_q, twin__control_q;
    wire        plain__run_q, twin__run_q, plain__to_q, twin__to_q;
    wire [29:0] left = twin__run_q ? twin__due_q - twin__now : twin__due_q;

    always @(*) if (live) begin
        i_ticks:   assert (twinticks__since == plainticks__count_q);
        i_counter: assert ({left, twin__phase_q} == plain__counter_q);
        i_period:  assert (twin__period_q == plain__period_q && twin__snap_q == plain__snap_q);
        i_flags:   assert ({twin__run_q, twin__to_q, twin__control_q}
                           == {plain__run_q, plain__to_q, plain__control_q});
    end
endmodule

// verilator lint_off DECLFILENAME
// In place of the one in sim/fpga/inside.v.
module clock_number (output wire [29:0] now_o);
    (* anyseq *) reg [29:0] number;
    assign now_o = number;
endmodule

`default_nettype wire
