// numbered_clocks.v - the numbers of clocks, for the proofs of what leaps over clocks in sim/fpga
//
// The number of the first clock is arbitrary, and each clock has the next one.

`default_nettype none

module numbered_clocks (
    input  wire        clk_i,
    input  wire [29:0] now_i,      // a clock_number's
    output reg         live_o      // a clock has passed, in which the harness resets
);
    reg [29:0] now_q;

    initial live_o = 1'b0;
    always @(posedge clk_i) begin
        live_o <= 1'b1;
        now_q  <= now_i;
    end
    always @(*) if (live_o) assume (now_i == now_q + 30'd1);
endmodule

// verilator lint_off DECLFILENAME
// In place of the one in sim/fpga/inside.v.
module clock_number (output wire [29:0] now_o);
    (* anyseq *) reg [29:0] number;
    assign now_o = number;
endmodule

`default_nettype wire
