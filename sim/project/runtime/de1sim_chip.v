// de1sim_chip.v - the chip around somebody's design: the board's pins as the simulation has them
//
// Three files are written for each project: de1sim_ports.vh and de1sim_wires.vh from the table of
// wires, sim/pins/chip_wires.def, and de1sim_design.vh, which instances the design between these
// wires and drives those outputs that it has not.
//
// Each edge of a clock is an evaluation of its own, in which the pins move once: what a part of the
// board has on its pins when its clock rises is what was there before that evaluation.
//
// The inputs that the table has as TAKEN are taken over when moved_i changes.  An evaluation then
// need not look at them, and all that hangs on them, at every clock.
//
// A wire that both sides may drive has a pull-up, as on the board: X_low_i says where the outside
// pulls it low, X_o is its level.

`default_nettype none

module de1sim_chip (
`include "de1sim_ports.vh"
);
    // ---- Clocks ----

    wire        CLOCK_50, CLOCK2_50 = CLOCK_50, CLOCK3_50 = CLOCK_50, CLOCK4_50 = CLOCK_50;
    de1sim_clock_50 clock_50(.clk_i(clock_50_i), .clk_o(CLOCK_50));  // beside de1sim_pll_tap
`ifdef DE1SIM_TRACE
    wire        high_at_clock_50 = CLOCK_50;
`else
    wire        high_at_clock_50 = 1'b1;  // a pin that rises with it: runtime/clocks.h counts
`endif
    wire        TD_CLK27 = clock_27_i;
    wire [63:0] pll_clocks = pll_clocks_i;  // taken from here by de1sim_pll_tap

    // ---- Wires of the board ----

`include "de1sim_wires.vh"

    // ---- The processor ----

    reg  [1:0]  hps_request = 2'd0;
    reg  [1:0]  hps_reset = 2'd0;
    reg  [31:0] hps_gp = 32'd0;
    wire [1:0]  hps_answer;
    wire [3:0]  hps_size;
    wire [39:0] hps_waits;
    wire [63:0] hps_irq;
    wire [31:0] hps_fpga_gp;
    wire [2:0]  hps_reset_requests;

    always @(posedge hps_moved_i or negedge hps_moved_i) begin
        hps_request <= hps_request_i;
        hps_reset <= hps_reset_i;
        hps_gp <= hps_gp_i;
    end

    assign hps_answer_o = hps_answer;
    assign hps_size_o = hps_size;
    assign hps_waits_o = hps_waits;
    assign hps_irq_o = hps_irq;
    assign hps_gp_o = hps_fpga_gp;
    assign hps_reset_requests_o = hps_reset_requests;

    // ---- The design ----

`include "de1sim_design.vh"
endmodule

`default_nettype wire
