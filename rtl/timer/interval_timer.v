// interval_timer.v - interval timer in the register layout of the DE1-SoC Computer, at 100 MHz
//
//   +00 STATUS     TO bit 0, RUN bit 1; any write clears TO
//   +04 CONTROL    ITO bit 0: interrupt while TO; CONT bit 1: go on after 0
//                  START bit 2, STOP bit 3: events, read 0; with both it starts
//   +08, +0C       PERIOD_LOW, PERIOD_HIGH, 16 bits each; a write loads the counter and stops it
//   +10, +14       SNAP_LOW, SNAP_HIGH: any write keeps the counter's value there
//
// The counter falls from the period to 0, sets TO and begins again: a period is PERIOD + 1 ticks.
// Four ticks of 100 MHz pass in a clock of 25 MHz; what is left of the four behind 0 counts towards
// the next period, so that the rate is exact and TO is at most 40 ns late.
//
// Source: Embedded Peripherals IP User Guide, Interval Timer Core.
//
// Not handled: periods of less than four ticks, which end once a clock.

`default_nettype none

module interval_timer (
    input  wire        clk_i,
    input  wire        rst_i,

    input  wire        we_i,
    input  wire [3:0]  wstrb_i,
    // Only the register's place in the block counts; registers have 16 bits.
    // verilator lint_off UNUSED
    input  wire [11:0] waddr_i,
    input  wire [11:0] raddr_i,
    input  wire [31:0] wdata_i,
    // verilator lint_on UNUSED
    input  wire        re_i,
    output reg  [31:0] rdata_o,
    output wire        irq_o
);
    `include "regmap.vh"
    `include "lanes.vh"

    localparam [31:0] TICKS = 32'd4;  // of 100 MHz in a clock

    reg [31:0] period_q, counter_q, snap_q;
    reg        to_q, run_q, ito_q, cont_q;

    assign irq_o = to_q && ito_q;

    // ---- Counter ----------------------------------------------------------
    // The counter anew, given the ticks behind the end.
    function [31:0] begun;
        input [31:0] late;
        begun = cont_q && period_q >= late ? period_q - late : period_q;
    endfunction

    // Half words, in the low half of a word on the bus.
    // verilator lint_off WIDTH
    function [15:0] half;
        input [15:0] old_half;
        half = merged(old_half, wdata_i, wstrb_i);
    endfunction
    // verilator lint_on WIDTH

    // The period as written, its high half or its low one.
    function [31:0] period;
        input high;
        period = high ? {half(period_q[31:16]), period_q[15:0]}
                 : {period_q[31:16], half(period_q[15:0])};
    endfunction

    always @(posedge clk_i) begin
        rdata_o <= 32'd0;
        if (re_i) case (raddr_i[4:0])
            TIMER0_STATUS[4:0]:      rdata_o <= {30'd0, run_q, to_q};
            TIMER0_CONTROL[4:0]:     rdata_o <= {30'd0, cont_q, ito_q};
            TIMER0_PERIOD_LOW[4:0]:  rdata_o <= {16'd0, period_q[15:0]};
            TIMER0_PERIOD_HIGH[4:0]: rdata_o <= {16'd0, period_q[31:16]};
            TIMER0_SNAP_LOW[4:0]:    rdata_o <= {16'd0, snap_q[15:0]};
            TIMER0_SNAP_HIGH[4:0]:   rdata_o <= {16'd0, snap_q[31:16]};
            default: ;
        endcase

        if (we_i && (waddr_i[4:0] == TIMER0_SNAP_LOW[4:0]
                     || waddr_i[4:0] == TIMER0_SNAP_HIGH[4:0])) snap_q <= counter_q;
        if (run_q) begin
            if (counter_q < TICKS) begin
                counter_q <= begun(TICKS - 32'd1 - counter_q);
                to_q      <= 1'b1;
                run_q     <= cont_q;
            end else begin
                counter_q <= counter_q - TICKS;
            end
        end
        if (we_i) case (waddr_i[4:0])
            TIMER0_STATUS[4:0]: to_q <= 1'b0;
            TIMER0_CONTROL[4:0]: if (wstrb_i[0]) begin
                ito_q  <= wdata_i[0];
                cont_q <= wdata_i[1];
                if (wdata_i[3]) run_q <= 1'b0;
                if (wdata_i[2]) run_q <= 1'b1;
            end
            TIMER0_PERIOD_LOW[4:0], TIMER0_PERIOD_HIGH[4:0]: begin
                counter_q <= period(waddr_i[4:0] == TIMER0_PERIOD_HIGH[4:0]);
                period_q  <= period(waddr_i[4:0] == TIMER0_PERIOD_HIGH[4:0]);
                run_q     <= 1'b0;
            end
            default: ;
        endcase
        if (rst_i) begin
            period_q  <= {TIMER0_PERIOD_HIGH_RESET[15:0], TIMER0_PERIOD_LOW_RESET[15:0]};
            counter_q <= {TIMER0_PERIOD_HIGH_RESET[15:0], TIMER0_PERIOD_LOW_RESET[15:0]};
            snap_q    <= 32'd0;
            {to_q, run_q, ito_q, cont_q} <= 4'd0;
        end
    end
endmodule

`default_nettype wire
