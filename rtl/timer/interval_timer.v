// interval_timer.v - interval timer in the register layout of the DE1-SoC Computer, at 100 MHz
//
//   +00 STATUS     TO bit 0, RUN bit 1; any write clears TO
//   +04 CONTROL    ITO bit 0: interrupt while TO; CONT bit 1: go on after 0
//                  START bit 2, STOP bit 3: events, read as written last; with both it starts
//   +08, +0C       PERIOD_LOW, PERIOD_HIGH, 16 bits each; a write loads the counter and stops it
//   +10, +14       SNAP_LOW, SNAP_HIGH: any write keeps the counter's value there
//
// The counter falls from the period to 0, sets TO and begins again: a period is PERIOD + 1 ticks.
// Four ticks of 100 MHz pass per clock of 25 MHz.  The ticks of these four that come after 0 count
// towards the next period, so the rate is exact and TO is at most 40 ns late.
//
// With PERIOD = 0 the counter is 0 all the time: TO is set once, when it becomes 0, also while the
// timer stands; without CONT a start ends at once.
//
// Source: Embedded Peripherals IP User Guide, Interval Timer Core, and the Verilog that it
// generates for the DE1-SoC Computer.
//
// Not handled: periods of two or three ticks; they end once per clock.
//
// In the simulation sim/fpga/interval_timer.v takes its place.

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
    reg  [31:0] counter_q;
    wire        ends = run_q && counter_q < TICKS;            // in this clock
    wire [31:0] late = TICKS - 32'd1 - counter_q;             // ticks of this clock after its end
    wire        cont = control_q[TIMER0_CONTROL_CONT_LSB];

    assign irq_o   = to_q && control_q[TIMER0_CONTROL_ITO_LSB];
    assign awake_o = rdata_o != 32'd0 || run_q;

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
        reg [31:0] next;   // after this clock
        reg        run;

        next = run_q ? counter_q - TICKS : counter_q;
        run  = run_q;
        if (ends) begin
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
                if (next == 32'd0 && counter_q != 32'd0) to_q <= 1'b1;
            end
            TIMER0_SNAP_LOW[4:0], TIMER0_SNAP_HIGH[4:0]: snap_q <= counter_q;
            default: ;
        endcase
        counter_q <= next;
        run_q     <= run;
        if (rst_i) begin
            period_q  <= PERIOD_RESET;
            counter_q <= PERIOD_RESET;
            snap_q    <= 32'd0;
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
