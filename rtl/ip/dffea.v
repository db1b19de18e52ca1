// dffea.v - primitive: a flip-flop with clock enable, which aload makes adata
//
// clrn before prn and aload, all at once.

`default_nettype none

module dffea (
    input  wire d,
    input  wire clk,
    input  wire clrn,
    input  wire prn,
    input  wire ena,
    input  wire adata,
    input  wire aload,
    output wire q
);
    reg q_q;
    always @(posedge clk or negedge clrn or negedge prn or posedge aload)
        if (!clrn) q_q <= 1'b0;
        else if (!prn) q_q <= 1'b1;
        else if (aload) q_q <= adata;
        else if (ena) q_q <= d;

    assign q = q_q;
endmodule

`default_nettype wire
