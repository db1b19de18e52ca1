// countdown_twin_formal.v - sim/fpga/countdown.v counts as rtl/common/countdown.v does
//
// By induction, from any count; loads and pauses are unconstrained.

`default_nettype none

module countdown_twin_formal (
    input wire       clk_i,
    input wire       load_i,
    input wire [7:0] value_i,
    input wire       run_i
);
    wire [7:0] plain_count, twin_count;
    wire       plain_zero, twin_zero;

    countdown plain (
        .clk_i(clk_i), .load_i(load_i), .value_i(value_i), .run_i(run_i), .count_o(plain_count),
        .zero_o(plain_zero), .awake_o()
    );
    countdown_twin twin (
        .clk_i(clk_i), .load_i(load_i), .value_i(value_i), .run_i(run_i), .count_o(twin_count),
        .zero_o(twin_zero), .awake_o()
    );

    wire [29:0] twin__now;
    wire        live;
    numbered_clocks clocks (.clk_i(clk_i), .now_i(twin__now), .live_o(live));
    always @(*) if (!live) assume (load_i);

    always @(*) if (live) begin
        a_count: assert (twin_count == plain_count);
        a_zero:  assert (twin_zero == plain_zero);
    end
endmodule

`default_nettype wire
