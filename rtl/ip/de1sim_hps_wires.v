// de1sim_hps_wires.v - the signals of one of the processor's peripherals, in the design
//
// They move whenever the processor or the design moves them, without a clock.  Before the program
// begins the design has IDLE.

`default_nettype none

module de1sim_hps_wires #(
    // verilator lint_off UNUSED
    parameter        KIND   = 0,   // as sim/pins/fpga_model.h has them
    parameter        NUMBER = -1,  // which of its kind; -1: by the instance's name
    // verilator lint_on UNUSED
    parameter        FROM   = 1,   // bits, up to 64
    parameter        TO     = 1,
    parameter [63:0] IDLE   = 64'd0
) (
    input  wire [FROM-1:0] from_i,  // the design
    output wire [TO-1:0]   to_o
);
`ifdef DE1SIM_LISTS
    // The design alone, without the chip.
    assign to_o = IDLE[TO-1:0];
    // verilator lint_off UNUSED
    wire unused = &{1'b0, from_i};
    // verilator lint_on UNUSED
`else
    `include "de1sim_hps_wires.vh"

    integer      peripheral = 0;
    // verilator lint_off UNUSED
    reg  [63:0]  levels_q = IDLE;
    // verilator lint_on UNUSED

    assign to_o = levels_q[TO-1:0];

    initial peripheral = de1sim_hps_peripheral(KIND, NUMBER, IDLE);

    always @(posedge de1sim_chip.hps_moved_i or negedge de1sim_chip.hps_moved_i)
        levels_q <= de1sim_hps_levels(peripheral);

    always @(from_i or peripheral)
        de1sim_hps_signals(peripheral, {{64 - FROM{1'b0}}, from_i});
`endif
endmodule

`default_nettype wire
