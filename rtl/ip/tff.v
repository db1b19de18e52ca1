// tff.v - primitive: a flip-flop that toggles; clrn before prn, both at once

`default_nettype none

module tff (
    input  wire t,
    input  wire clk,
    input  wire clrn,
    input  wire prn,
    output wire q
);
    reg q_q;
    always @(posedge clk or negedge clrn or negedge prn)
        if (!clrn) q_q <= 1'b0;
        else if (!prn) q_q <= 1'b1;
        else q_q <= q_q ^ t;

    assign q = q_q;
endmodule

`default_nettype wire
