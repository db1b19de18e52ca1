// prescaler_twin_formal.v - sim/fpga/prescaler.v ticks as rtl/common/prescaler.v does
//
// By induction; resets are unconstrained.

`default_nettype none

module prescaler_twin_formal (
    input wire clk_i,
    input wire rst_i
);
    wire plain_tick, twin_tick;

    prescaler plain (
        .clk_i(clk_i), .rst_i(rst_i), .wanted_i(1'b1), .tick_o(plain_tick), .awake_o()
    );
    prescaler_twin twin (
        .clk_i(clk_i), .rst_i(rst_i), .wanted_i(1'b1), .tick_o(twin_tick), .awake_o()
    );

    wire [29:0] twin__now;
    wire [4:0]  plain__count_q, twin__since;
    wire        live;
    numbered_clocks clocks (.clk_i(clk_i), .now_i(twin__now), .live_o(live));
    always @(*) if (!live) assume (rst_i);

    always @(*) if (live) begin
        a_tick:  assert (twin_tick == plain_tick);
        i_count: assert (twin__since == plain__count_q);
    end
endmodule

`default_nettype wire
