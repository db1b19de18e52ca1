// counter_top.v - the counter on the digits of a DE1-SoC (counter.qsf) or DE10-Standard
// (counter_standard.qsf)

module counter_top (
    input  wire       CLOCK_50,
    output wire [6:0] HEX0, HEX1, HEX2, HEX3
);
    wire [15:0] digits;

    counter_system system (.clk(CLOCK_50), .digits(digits));

    seven_segment digit0 (digits[3:0], HEX0);
    seven_segment digit1 (digits[7:4], HEX1);
    seven_segment digit2 (digits[11:8], HEX2);
    seven_segment digit3 (digits[15:12], HEX3);
endmodule
