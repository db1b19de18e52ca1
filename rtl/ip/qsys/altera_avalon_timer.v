// altera_avalon_timer.v - Platform Designer's interval timer, of 32 or 64 bits, in its own clock
//
//   0 status   TO bit 0, RUN bit 1; any write clears TO
//   1 control  ITO bit 0: interrupt while TO; CONT bit 1: go on after 0; START bit 2, STOP bit 3
//   2 period, its lowest 16 bits, then the others, 2 or 4 words; a write stops the counter, which
//     is loaded a clock later.  The next 2 or 4 words are snap: a write keeps the counter there.
//
// The counter falls from the period to 0 and begins again: a period is its value and one clock.
// START, STOP and TO's clearing act with the write; TO is set in the clock after that of the 0.
// With ALWAYS_RUN there is no START, STOP or CONT: the counter runs on.
//
// Source: Embedded Peripherals IP User Guide, Interval Timer Core; the Verilog that it generates.

`default_nettype none

module altera_avalon_timer #(
    parameter        SIZE         = 32,
    parameter [63:0] LOAD         = 64'd49999,
    parameter        ALWAYS_RUN   = 0,
    parameter        FIXED_PERIOD = 0,
    parameter        SNAPSHOT     = 1
) (
    input  wire                         clk,
    input  wire                         reset_n,
    input  wire [(SIZE == 64 ? 3 : 2):0] address,
    input  wire                         chipselect,
    input  wire                         write_n,
    input  wire [15:0]                  writedata,
    output reg  [15:0]                  readdata,
    output wire                         irq,
    output reg                          timeout_pulse,
    output wire                         resetrequest
);
    localparam       WORDS = SIZE / 16;
    localparam [3:0] STATUS = 4'd0, CONTROL = 4'd1, PERIOD = 4'd2, SNAP = PERIOD + WORDS[3:0],
                     END = SNAP + WORDS[3:0];

    wire [3:0] at = {{(SIZE == 64 ? 0 : 1){1'b0}}, address};
    wire       we = chipselect && !write_n;
    wire       we_period = we && at >= PERIOD && at < SNAP && FIXED_PERIOD == 0;
    wire       we_snap   = we && at >= SNAP && at < END && SNAPSHOT != 0;
    wire       we_control = we && at == CONTROL;

    reg [SIZE - 1:0] period_q, counter_q, snap_q;
    reg [3:0]        control_q;
    reg              reload_q, run_q, zero_q, to_q;

    wire zero = counter_q == {SIZE{1'b0}};
    wire cont = control_q[1] || ALWAYS_RUN != 0;
    wire timeout = zero && !zero_q;

    assign irq = to_q && control_q[0];
    assign resetrequest = timeout_pulse;

    integer n;
    always @(posedge clk) begin
        if (!reset_n) begin
            period_q <= LOAD[SIZE - 1:0];
            counter_q <= LOAD[SIZE - 1:0];
            snap_q <= {SIZE{1'b0}};
            control_q <= 4'd0;
            {reload_q, run_q, zero_q, to_q, timeout_pulse} <= 5'd0;
            readdata <= 16'd0;
        end else begin
            reload_q <= we_period;
            zero_q <= zero;
            timeout_pulse <= timeout;
            if (run_q || reload_q)
                counter_q <= zero || reload_q ? period_q : counter_q - {{SIZE - 1{1'b0}}, 1'b1};
            if ((we_control && writedata[2]) || ALWAYS_RUN != 0) run_q <= 1'b1;
            else if ((we_control && writedata[3]) || reload_q || (zero && !cont)) run_q <= 1'b0;
            if (we && at == STATUS) to_q <= 1'b0;
            else if (timeout) to_q <= 1'b1;
            if (we_control) control_q <= writedata[3:0];
            if (we_snap) snap_q <= counter_q;
            for (n = 0; n < WORDS; n = n + 1)
                if (we_period && at == PERIOD + n[3:0]) period_q[16 * n +: 16] <= writedata;

            readdata <= at == STATUS ? {14'd0, run_q, to_q}
                        : at == CONTROL ? {12'd0, control_q} : 16'd0;
            for (n = 0; n < WORDS; n = n + 1) begin
                if (at == PERIOD + n[3:0]) readdata <= period_q[16 * n +: 16];
                if (at == SNAP + n[3:0]) readdata <= snap_q[16 * n +: 16];
            end
        end
    end
endmodule

`default_nettype wire
