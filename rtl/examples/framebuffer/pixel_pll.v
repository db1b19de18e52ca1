// pixel_pll.v - 25 MHz of the board's 50 MHz, as Quartus' wizard makes it

module pixel_pll (
    inclk0,
    c0,
    locked);

    input  inclk0;
    output c0;
    output locked;

    wire [4:0] clocks;
    assign c0 = clocks[0];

    altpll pll (
        .inclk ({1'b0, inclk0}),
        .clk (clocks),
        .locked (locked),
        .areset (1'b0));
    defparam
        pll.clk0_divide_by = 2,
        pll.clk0_duty_cycle = 50,
        pll.clk0_multiply_by = 1,
        pll.clk0_phase_shift = "0",
        pll.inclk0_input_frequency = 20000,
        pll.intended_device_family = "Cyclone V",
        pll.lpm_type = "altpll",
        pll.operation_mode = "NORMAL",
        pll.port_clk0 = "PORT_USED",
        pll.port_clk1 = "PORT_UNUSED",
        pll.port_locked = "PORT_USED",
        pll.width_clock = 5;
endmodule
