// interval_timer.v - in the simulation: rtl/timer/interval_timer.v without a counter
//
// While the timer runs nothing counts down: the counter is computed from the clock in which it
// ends, so the timer sleeps.  At its ports it is rtl/timer/interval_timer.v, but for awake_o
// (tb/formal/leaps_formal.v).

`default_nettype none

module interval_timer (
    input  wire        clk_i,
    input  wire        rst_i,

    input  wire        we_i,
    input  wire [3:0]  wstrb_i,
    // Only the register's offset in the block is used; registers have 16 bits.
    // verilator lint_off UNUSED
    input  wire [11:0] waddr_i,
    input  wire [11:0] raddr_i,
    input  wire [31:0] wdata_i,
    // verilator lint_on UNUSED
    input  wire        re_i,
    output reg  [31:0] rdata_o,
    output wire        irq_o,
    output wire        awake_o
);
    `include "regmap.vh"
    `include "lanes.vh"

    localparam [31:0] TICKS = 32'd4;  // of 100 MHz per clock
    localparam [31:0] PERIOD_RESET = {TIMER0_PERIOD_HIGH_RESET[15:0],
                                      TIMER0_PERIOD_LOW_RESET[15:0]};

    reg [31:0] period_q, snap_q;
    reg [3:0]  control_q;
    reg        to_q, run_q;

    // ---- Counter ----------------------------------------------------------
    wire [29:0] now;
    clock_number number (.now_o(now));

    reg  [29:0] due_q;    // the clock in which it ends; or, while stopped, the counter's bits 31:2
    reg  [1:0]  phase_q;  // bits 1:0 of the counter
    wire [29:0] left = due_q - now;
    wire        cont = control_q[TIMER0_CONTROL_CONT_LSB];

    assign irq_o   = to_q && control_q[TIMER0_CONTROL_ITO_LSB];
    assign awake_o = rdata_o != 32'd0;

    // For fpga_clocks.v.
    wire       due  = run_q && due_q == now;
    wire [9:0] rest = run_q && left[29:10] == 20'd0 ? left[9:0] - 10'd1 : 10'd1023;

    // Registers have 16 bits, in the low half of the bus's word.
    // verilator lint_off WIDTH
    function [15:0] half;
        input [15:0] old_half;
        half = merged(old_half, wdata_i, wstrb_i);
    endfunction
    // verilator lint_on WIDTH

    // The period after a write to its high or its low half.
    function [31:0] period;
        input high;
        period = high ? {half(period_q[31:16]), period_q[15:0]}
                 : {period_q[31:16], half(period_q[15:0])};
    endfunction

    // verilator lint_off BLKSEQ
    always @(posedge clk_i) begin : count
        reg [31:0] counter, late, next;   // now; ticks after its end; after this clock
        reg        run;                   // after this clock

        counter = {run_q ? left : due_q, phase_q};
        late    = TICKS - 32'd1 - counter;
        next    = run_q ? counter - TICKS : counter;
        run     = run_q;
        if (due) begin
            next = cont && period_q >= late ? period_q - late : period_q;
            run  = cont;
            if (period_q != 32'd0) to_q <= 1'b1;
        end
        if (we_i) case (waddr_i[4:0])
            TIMER0_STATUS[4:0]: to_q <= 1'b0;
            TIMER0_CONTROL[4:0]: if (wstrb_i[0]) begin
                control_q <= wdata_i[3:0];
                run       = wdata_i[TIMER0_CONTROL_START_LSB]
                            || (run && !wdata_i[TIMER0_CONTROL_STOP_LSB]);
            end
            TIMER0_PERIOD_LOW[4:0], TIMER0_PERIOD_HIGH[4:0]: begin
                next     = period(waddr_i[4:0] == TIMER0_PERIOD_HIGH[4:0]);
                period_q <= next;
                run      = 1'b0;
                if (next == 32'd0 && counter != 32'd0) to_q <= 1'b1;
            end
            TIMER0_SNAP_LOW[4:0], TIMER0_SNAP_HIGH[4:0]: snap_q <= counter;
            default: ;
        endcase
        due_q   <= run ? now - ~next[31:2] : next[31:2];   // now + 1 + next, by one adder
        phase_q <= next[1:0];
        run_q   <= run;
        if (rst_i) begin
            period_q         <= PERIOD_RESET;
            {due_q, phase_q} <= PERIOD_RESET;
            snap_q           <= 32'd0;
            {to_q, run_q, control_q} <= 6'd0;
        end
    end
    // verilator lint_on BLKSEQ

    // ---- Reads ------------------------------------------------------------
    always @(posedge clk_i) begin
        rdata_o <= 32'd0;
        if (re_i) case (raddr_i[4:0])
            TIMER0_STATUS[4:0]: begin
                rdata_o[TIMER0_STATUS_TO_LSB]  <= to_q;
                rdata_o[TIMER0_STATUS_RUN_LSB] <= run_q;
            end
            TIMER0_CONTROL[4:0]:     rdata_o <= {28'd0, control_q};
            TIMER0_PERIOD_LOW[4:0]:  rdata_o <= {16'd0, period_q[15:0]};
            TIMER0_PERIOD_HIGH[4:0]: rdata_o <= {16'd0, period_q[31:16]};
            TIMER0_SNAP_LOW[4:0]:    rdata_o <= {16'd0, snap_q[15:0]};
            TIMER0_SNAP_HIGH[4:0]:   rdata_o <= {16'd0, snap_q[31:16]};
            default: ;
        endcase
    end
endmodule

`default_nettype wire
