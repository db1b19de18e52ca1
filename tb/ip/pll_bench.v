// pll_bench.v - PLLs as wizards and people write them

`default_nettype none

module pll_bench (
    input  wire       refclk_i,
    input  wire       rst_i,
    input  wire [1:0] clkena_i,
    input  wire       pllena_i,
    input  wire [2:0] clocks_i,      // what de1sim_pll_tap gives

    output wire [1:0] wizard_o,
    output wire       wizard_locked_o,
    output wire       short_o,
    output wire [1:0] gated_o,
    output wire [3:0] generated_o,
    output wire       generated_locked_o
);
    wizard_pll wizard (.areset(rst_i), .inclk0(refclk_i), .c0(wizard_o[0]), .c1(wizard_o[1]),
                       .locked(wizard_locked_o));

    // A VGA adapter's: only what it needs.
    wire [5:0] short_clocks;
    assign short_o = short_clocks[0];
    altpll short (.inclk({1'b0, refclk_i}), .clk(short_clocks));
    defparam
        short.operation_mode = "NORMAL",
        short.intended_device_family = "Cyclone II",
        short.lpm_type = "altpll",
        short.pll_type = "FAST",
        short.inclk0_input_frequency = 20000,
        short.primary_clock = "INCLK0",
        short.compensate_clock = "CLK0",
        short.clk0_phase_shift = "0",
        short.clk0_divide_by = 2,
        short.clk0_multiply_by = 1,
        short.clk0_duty_cycle = 50;

    wire [4:0] gated_clocks;
    assign gated_o = gated_clocks[1:0];
    altpll #(
        .WIDTH_CLOCK(5), .INCLK0_INPUT_FREQUENCY(37037), .CLK0_MULTIPLY_BY(14),
        .CLK0_DIVIDE_BY(15), .PORT_CLK0("PORT_USED"), .CLK1_MULTIPLY_BY(1), .CLK1_DIVIDE_BY(2),
        .PORT_CLK1("PORT_UNUSED"), .PORT_CLKENA0("PORT_USED"), .PORT_PLLENA("PORT_USED")
    ) gated (
        .inclk({1'b0, refclk_i}), .clk(gated_clocks), .clkena({4'd0, clkena_i}),
        .pllena(pllena_i), .areset(1'b0));

    altera_pll #(
        .fractional_vco_multiplier("false"),
        .reference_clock_frequency("50.0 MHz"),
        .operation_mode("direct"),
        .number_of_clocks(4),
        .output_clock_frequency0("25.175000 MHz"),
        .phase_shift0("0 ps"),
        .duty_cycle0(50),
        .output_clock_frequency1("100.000000 MHz"),
        .phase_shift1("-3000 ps"),
        .duty_cycle1(25),
        .output_clock_frequency2("0 MHz"),
        .phase_shift2("0 ps"),
        .duty_cycle2(50),
        .OUTPUT_CLOCK_FREQUENCY3("12.5 kHz"),
        .PHASE_SHIFT3("1.5 ns"),
        .output_clock_frequency4("33.0 MHz"),
        .pll_type("General"),
        .pll_subtype("General")
    ) altera_pll_i (
        .rst(rst_i), .outclk(generated_o), .locked(generated_locked_o), .fboutclk(),
        .fbclk(1'b0), .refclk(refclk_i));
endmodule

`default_nettype wire
