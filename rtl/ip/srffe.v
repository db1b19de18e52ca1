// srffe.v - primitive: srff with clock enable; clrn before prn, both at once

`default_nettype none

module srffe (
    input  wire s,
    input  wire r,
    input  wire clk,
    input  wire clrn,
    input  wire prn,
    input  wire ena,
    output wire q
);
    reg q_q;
    always @(posedge clk or negedge clrn or negedge prn)
        if (!clrn) q_q <= 1'b0;
        else if (!prn) q_q <= 1'b1;
        else if (ena) q_q <= s && !q_q || !r && q_q;

    assign q = q_q;
endmodule

`default_nettype wire
