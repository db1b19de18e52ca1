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
    reg  [29:0] now_q;
    reg         live = 1'b0;
    always @(posedge clk_i) begin
        live  <= 1'b1;
        now_q <= twin__now;
    end
    always @(*)
        if (!live) assume (load_i);
        else assume (twin__now == now_q + 30'd1);

    always @(*) if (live) begin
        a_count: assert (twin_count == plain_count);
        a_zero:  assert (twin_zero == plain_zero);
    end
endmodule

// The number of the clock, which the harness bounds.
module clock_number (output wire [29:0] now_o);
    (* anyseq *) reg [29:0] number;
    assign now_o = number;
endmodule

`default_nettype wire
