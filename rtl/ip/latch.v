// latch.v - primitive: open while ena is 1

`default_nettype none

module latch (
    input  wire d,
    input  wire ena,
    output wire q
);
    reg q_q;
    // It is meant to be one.
    // verilator lint_off LATCH
    always @* if (ena) q_q = d;
    // verilator lint_on LATCH
    assign q = q_q;
endmodule

`default_nettype wire
