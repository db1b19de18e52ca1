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
    reg  [29:0] now_q;
    reg         live = 1'b0;
    always @(posedge clk_i) begin
        live  <= 1'b1;
        now_q <= twin__now;
    end
    always @(*)
        if (!live) assume (rst_i);
        else assume (twin__now == now_q + 30'd1);

    always @(*) if (live) begin
        a_tick:  assert (twin_tick == plain_tick);
        i_count: assert (twin__since == plain__count_q);
    end
endmodule

// The number of the clock, which the harness bounds.
module clock_number (output wire [29:0] now_o);
    (* anyseq *) reg [29:0] number;
    assign now_o = number;
endmodule

`default_nettype wire
