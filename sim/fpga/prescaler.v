// prescaler.v - in the simulation: rtl/common/prescaler.v, which never counts
//
// A tick is computed from the number of the clock.  At its ports it is rtl/common/prescaler.v, but
// for awake_o (tb/formal/leaps_formal.v).

`default_nettype none

module prescaler (
    input  wire clk_i,
    input  wire rst_i,
    input  wire wanted_i,
    output wire tick_o,
    output wire awake_o
);
    // Only the low bits are used.
    // verilator lint_off UNUSED
    wire [29:0] now;
    // verilator lint_on UNUSED
    clock_number number (.now_o(now));

    reg  [4:0] first_q;                  // the clock of the first tick
    wire [4:0] since = now[4:0] - first_q;

    assign tick_o  = since == 5'd0;
    assign awake_o = 1'b0;

    always @(posedge clk_i) if (rst_i) first_q <= now[4:0] + 5'd1;

    // ---- For fpga_clocks.v --------------------------------------------------
    wire       due  = wanted_i && tick_o;
    wire [9:0] rest = wanted_i ? {5'd0, 5'd31 - since} : 10'd1023;
endmodule

`default_nettype wire
