// clock_reset.v - the fabric's clock from the board's, and its reset
//
//   refclk_i, 50 MHz --> altera_pll --> clk_o, 25 MHz
//   PLL locked, rst_ni high --> reset_sync --> rst_o, synchronous to clk_o

`default_nettype none

module clock_reset (
    input  wire refclk_i,
    input  wire rst_ni,     // asynchronous, active low
    output wire clk_o,
    output wire rst_o
);
    wire clk, locked;

    assign clk_o = clk;

    altera_pll #(
        .reference_clock_frequency ("50.0 MHz"),
        .operation_mode            ("direct"),
        .fractional_vco_multiplier ("false"),
        .number_of_clocks          (1),
        .output_clock_frequency0   ("25.000000 MHz"),
        .phase_shift0              ("0 ps"),
        .duty_cycle0               (50),
        .pll_type                  ("General"),
        .pll_subtype               ("General")
    ) pll (
        .refclk   (refclk_i),
        .rst      (1'b0),
        .fbclk    (1'b0),
        // verilator lint_off PINCONNECTEMPTY
        .fboutclk (),
        // verilator lint_on PINCONNECTEMPTY
        .outclk   (clk),
        .locked   (locked)
    );

    reset_sync reset_sync (.clk_i(clk), .rst_ni(locked && rst_ni), .rst_o(rst_o));
endmodule

`default_nettype wire
