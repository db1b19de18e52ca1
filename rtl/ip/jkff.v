// jkff.v - primitive: j sets, k clears, both toggle; clrn before prn, both at once

`default_nettype none

module jkff (
    input  wire j,
    input  wire k,
    input  wire clk,
    input  wire clrn,
    input  wire prn,
    output wire q
);
    reg q_q;
    always @(posedge clk or negedge clrn or negedge prn)
        if (!clrn) q_q <= 1'b0;
        else if (!prn) q_q <= 1'b1;
        else q_q <= j && !q_q || !k && q_q;

    assign q = q_q;
endmodule

`default_nettype wire
