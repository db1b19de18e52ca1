// de1sim_mult_add_register.v - STAGES registers with a clock and clears that are chosen
//
// CLOCK, ACLR and SCLR are 0 to 3, or 4 for none; without a clock it is a wire.

`default_nettype none

// A width is compared with another instance's, by Verilator 5.006, where there are many.
// verilator lint_off WIDTH

module de1sim_mult_add_register #(
    parameter       WIDTH  = 1,
    parameter       STAGES = 1,
    parameter [2:0] CLOCK  = 3'd4,
    parameter [2:0] ACLR   = 3'd4,
    parameter [2:0] SCLR   = 3'd4
) (
    input  wire [3:0]       clock_i, ena_i, aclr_i, sclr_i,
    input  wire [WIDTH-1:0] d_i,
    output wire [WIDTH-1:0] q_o
);
    de1sim_pipeline #(.WIDTH(WIDTH), .STAGES(CLOCK < 4 ? STAGES : 0)) registers (
        .clock_i(clock_i[CLOCK[1:0]]), .clken_i(ena_i[CLOCK[1:0]]),
        .aclr_i(ACLR < 4 && aclr_i[ACLR[1:0]]), .sclr_i(SCLR < 4 && sclr_i[SCLR[1:0]]),
        .d_i(d_i), .q_o(q_o));
// verilator lint_on WIDTH
endmodule

`default_nettype wire
