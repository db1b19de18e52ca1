// counter_nano.v - the counter on the LEDs of a DE10-Nano: two decimal digits, four LEDs each

module counter_nano (
    input  wire       FPGA_CLK1_50,
    output wire [7:0] LED
);
    wire [15:0] digits;

    counter_system system (.clk(FPGA_CLK1_50), .digits(digits));

    assign LED = digits[7:0];
endmodule
