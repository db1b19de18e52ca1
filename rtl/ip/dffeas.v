// dffeas.v - primitive: the flip-flop of a logic cell
//
// clrn before prn and aload, all at once; at the clock with ena sclr before sload before d.

`default_nettype none

module dffeas #(
    parameter power_up = "DONT_CARE", POWER_UP = power_up,
    parameter is_wysiwyg = "false", IS_WYSIWYG = is_wysiwyg,
    parameter dont_touch = "false", DONT_TOUCH = dont_touch,
    parameter x_on_violation = "on", X_ON_VIOLATION = x_on_violation,
    parameter lpm_type = "dffeas", LPM_TYPE = lpm_type
) (
    input  wire d,
    input  wire clk,
    input  wire clrn,
    input  wire prn,
    input  wire ena,
    input  wire asdata,
    input  wire aload,
    input  wire sclr,
    input  wire sload,
    input  wire devclrn,
    input  wire devpor,
    output wire q
);
    reg q_q;
    always @(posedge clk or negedge clrn or negedge prn or posedge aload)
        if (!clrn) q_q <= 1'b0;
        else if (!prn) q_q <= 1'b1;
        else if (aload) q_q <= asdata;
        else if (ena) q_q <= sclr ? 1'b0 : sload ? asdata : d;

    assign q = q_q;
endmodule

`default_nettype wire
