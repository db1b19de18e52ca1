// countdown.v - in the simulation: rtl/common/countdown.v, which sleeps while it counts
//
// While it runs nothing counts down: the count is computed from the clock in which it ends.  At its
// ports it is rtl/common/countdown.v, but for awake_o (tb/formal/leaps_formal.v).

`default_nettype none

module countdown #(
    parameter WIDTH = 8                  // up to 30
) (
    input  wire             clk_i,
    input  wire             load_i,
    input  wire [WIDTH-1:0] value_i,
    input  wire             run_i,
    output wire [WIDTH-1:0] count_o,
    output wire             zero_o,
    output wire             awake_o
);
    // Only the low bits are used.
    // verilator lint_off UNUSED
    wire [29:0] now;
    // verilator lint_on UNUSED
    clock_number number (.now_o(now));

    reg              running_q;          // run_i of the clock before
    reg  [WIDTH-1:0] due_q;              // running: the clock in which it ends; else the count
    wire [WIDTH-1:0] left = due_q - now[WIDTH-1:0];
    wire [WIDTH-1:0] next = load_i ? value_i : run_i && !zero_o ? count_o - 1'b1 : count_o;

    assign count_o = running_q ? left : due_q;
    assign zero_o  = count_o == {WIDTH{1'b0}};
    assign awake_o = run_i != running_q;

    always @(posedge clk_i) begin
        running_q <= run_i;
        due_q     <= run_i ? now[WIDTH-1:0] + 1'b1 + next : next;
    end

    // ---- For fpga_clocks.v --------------------------------------------------
    wire       due  = running_q && left == {WIDTH{1'b0}};
    // verilator lint_off WIDTH
    wire [9:0] rest = running_q && left < 1024 ? left - 1 : 10'd1023;
    // verilator lint_on WIDTH
endmodule

`default_nettype wire
