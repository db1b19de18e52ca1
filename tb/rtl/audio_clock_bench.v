// audio_clock_bench.v - the board's audio clocks of both rates: bit 0 of 8,000, bit 1 of 48,000
// samples per second.  The test is their PLL.

`default_nettype none

// verilator lint_off DECLFILENAME
// verilator lint_off UNUSED

module audio_clock_bench (
    input  wire       pll_i,
    input  wire       locked_i,
    input  wire       rst_ni,
    output wire [1:0] xck_o,
    output wire [1:0] clk_o,
    output wire [1:0] rst_o
);
    audio_clock slow (
        .refclk_i(1'b0), .rst_ni(rst_ni), .xck_o(xck_o[0]), .clk_o(clk_o[0]), .rst_o(rst_o[0])
    );
    audio_clock #(.RATE(48000)) fast (
        .refclk_i(1'b0), .rst_ni(rst_ni), .xck_o(xck_o[1]), .clk_o(clk_o[1]), .rst_o(rst_o[1])
    );
endmodule

module altera_pll #(
    parameter reference_clock_frequency = "", operation_mode = "", fractional_vco_multiplier = "",
              number_of_clocks = 1, output_clock_frequency0 = "", phase_shift0 = "",
              duty_cycle0 = 50, pll_type = "", pll_subtype = ""
) (
    input  wire refclk,
    input  wire rst,
    input  wire fbclk,
    output wire fboutclk,
    output wire outclk,
    output wire locked
);
    assign fboutclk = 1'b0;
    assign outclk   = audio_clock_bench.pll_i;
    assign locked   = audio_clock_bench.locked_i;
endmodule

`default_nettype wire
