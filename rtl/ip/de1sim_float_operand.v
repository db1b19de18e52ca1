// de1sim_float_operand.v - the parts of a floating-point number; a denormal one is 0

`default_nettype none

module de1sim_float_operand #(
    parameter EXP = 8,
    parameter MAN = 23
) (
    input  wire [EXP+MAN:0] number_i,
    output wire             sign_o, nan_o, infinity_o, zero_o,
    output wire [EXP-1:0]   exponent_o,
    output wire [MAN:0]     significand_o   // with the 1 that is not stored
);
    wire top = exponent_o == {EXP{1'b1}};
    assign {sign_o, exponent_o} = number_i[EXP+MAN:MAN];
    assign significand_o = {1'b1, number_i[MAN-1:0]};
    assign zero_o        = exponent_o == {EXP{1'b0}};
    assign nan_o         = top && number_i[MAN-1:0] != {MAN{1'b0}};
    assign infinity_o    = top && !nan_o;
endmodule

`default_nettype wire
