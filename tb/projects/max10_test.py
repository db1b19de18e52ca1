"""max10_test.py DE1SIM FOLDER [CASE...] - the converter of a DE10-Lite's MAX 10, and its PLL"""
from case import Case, run
from systems import qsys

QSF = """set_global_assignment -name FAMILY "MAX 10"
set_global_assignment -name DEVICE 10M50DAF484C7G
set_global_assignment -name TOP_LEVEL_ENTITY top
set_global_assignment -name VERILOG_FILE top.v
"""
SYSTEM = "set_global_assignment -name QSYS_FILE sys.qsys\n"
PLL = {"INCLK0_INPUT_FREQUENCY": "20000", "PORT_clk0": "PORT_USED", "CLK0_MULTIPLY_BY": "1",
       "CLK0_DIVIDE_BY": "5", "CLK0_PHASE_SHIFT": "0", "PORT_LOCKED": "PORT_USED"}
CLOCKS = [("clock", "clk_0.clk", "pll.inclk_interface"),
          ("reset", "clk_0.clk_reset", "pll.inclk_interface_reset"),
          ("clock", "clk_0.clk", "adc.clock"), ("reset", "clk_0.clk_reset", "adc.reset_sink"),
          ("clock", "pll.c0", "adc.adc_pll_clock"),
          ("conduit", "pll.locked_conduit", "adc.adc_pll_locked")]


class Converter(Case):
    def volts(self, channel, volts, steps):
        """The upper ten of the converter's twelve bits are on the LEDs."""
        self.plays(f"set-voltage: {{channel: {channel}, volts: {volts}}}", "delay: 1ms",
                   f'expect-leds: "{steps >> 2:010b}"', project="p.qsf")

    def system(self, modules, connections, exports, top):
        self.write(p_qsf=QSF + SYSTEM, top_v=top,
                   sys_qsys=qsys([("clk_0", "clock_source", {}), *modules], connections, exports))

    # As the wizard's Verilog names it: channel 1 has wire 4.
    def test_of_the_primitive_has_4096_steps_of_5_volts(self):
        self.write(p_qsf=QSF, top_v="""module top(input MAX10_CLK1_50, output [9:0] LEDR);
wire [4:0] clk; wire [11:0] steps, taken; wire eoc; reg [11:0] kept;
altpll #(.inclk0_input_frequency(20000), .clk0_multiply_by(1), .clk0_divide_by(5), .width_clock(5),
         .port_clk0("PORT_USED")) pll(.inclk({1'b0, MAX10_CLK1_50}), .clk(clk));
fiftyfivenm_adcblock #(.clkdiv(2)) adc(.clkin_from_pll_c0(clk[0]), .soc(1'b1), .usr_pwd(1'b0),
    .tsen(1'b0), .chsel(5'd4), .clk_dft(), .eoc(eoc), .dout(steps));
always @(posedge eoc) kept <= steps;
assign LEDR = kept[11:2];
endmodule
""")
        self.volts(0, 2.5, 2048)
        self.volts(0, 5, 4095)
        self.volts(1, 5, 0)

    # The count of conversions in a millisecond.
    def test_of_the_primitive_makes_a_million_conversions_a_second(self):
        self.write(p_qsf=QSF, top_v="""module top(input MAX10_CLK1_50, output [9:0] LEDR);
wire [4:0] clk; wire eoc; reg [15:0] clocks = 0; reg [9:0] count = 0;
altpll #(.inclk0_input_frequency(20000), .clk0_multiply_by(1), .clk0_divide_by(5), .width_clock(5),
         .port_clk0("PORT_USED")) pll(.inclk({1'b0, MAX10_CLK1_50}), .clk(clk));
fiftyfivenm_adcblock #(.clkdiv(2)) adc(.clkin_from_pll_c0(clk[0]), .soc(1'b1), .usr_pwd(1'b0),
    .tsen(1'b0), .chsel(5'd4), .clk_dft(), .eoc(eoc), .dout());
reg [2:0] seen;
always @(posedge MAX10_CLK1_50) begin
    seen <= {seen[1:0], eoc};
    if (clocks != 16'd25000) begin
        clocks <= clocks + 1;
        if (seen[2:1] == 2'b01 && clocks >= 16'd5000) count <= count + 1;
    end
end
assign LEDR = count;
endmodule
""")
        self.plays("delay: 100ms", f'expect-leds: "{400:010b}"', project="p.qsf")

    def test_answers_commands_with_their_channel(self):
        self.system([("pll", "altpll", PLL), ("adc", "altera_modular_adc",
                                              {"CORE_VAR": "3", "clkdiv": "2"})], CLOCKS,
                    [("command", "adc.command"), ("response", "adc.response")],
                    """module top(input MAX10_CLK1_50, input [9:0] SW, output reg [9:0] LEDR);
wire valid; wire [4:0] channel; wire [11:0] steps;
sys system(.clk_clk(MAX10_CLK1_50), .reset_reset_n(1'b1), .command_valid(1'b1),
    .command_channel({2'd0, SW[2:0]}), .command_startofpacket(1'b1), .command_endofpacket(1'b1),
    .response_valid(valid), .response_channel(channel), .response_data(steps));
always @(posedge MAX10_CLK1_50) if (valid && channel == {2'd0, SW[2:0]}) LEDR <= steps[11:2];
endmodule
""")
        self.plays("set-voltage: {channel: 0, volts: 1.25}", "set-voltage: {channel: 5, volts: 3}",
                   "hold: {switch: 0}", "delay: 3ms", f'expect-leds: "{1024 >> 2:010b}"',
                   "hold: {switch: [1, 2]}", "release: {switch: 0}", "delay: 3ms",
                   f'expect-leds: "{2457 >> 2:010b}"', project="p.qsf")

    def test_stores_the_samples_of_a_sequence(self):
        slots = {"seq_order_length": "2", "seq_order_slot_1": "2", "seq_order_slot_2": "1"}
        self.system([("pll", "altpll", PLL), ("adc", "altera_modular_adc",
                                              {"CORE_VAR": "0", "clkdiv": "2", **slots})], CLOCKS,
                    [("csr", "adc.sequencer_csr"), ("store", "adc.sample_store_csr"),
                     ("irq", "adc.sample_store_irq")],
                    """module top(input MAX10_CLK1_50, output reg [9:0] LEDR);
wire irq; wire [31:0] data; reg [7:0] n = 0; reg [1:0] latency = 0;
sys system(.clk_clk(MAX10_CLK1_50), .reset_reset_n(1'b1), .csr_address(1'b0), .csr_read(1'b0),
    .csr_write(n == 8'd200), .csr_writedata(32'd3), .csr_readdata(),
    .store_address(7'd0), .store_read(irq), .store_write(1'b0), .store_writedata(32'd0),
    .store_readdata(data), .irq_irq(irq));
always @(posedge MAX10_CLK1_50) begin
    if (n != 8'hff) n <= n + 1;
    latency <= {latency[0], irq};
    if (latency[1]) LEDR <= data[11:2];
end
endmodule
""")
        self.volts(1, 4, 3276)

    def test_of_the_university_program_shows_its_channels(self):
        self.system([("mega", "altera_up_avalon_adc_mega",
                      {"board": "DE10-Lite", "numch_": "6", "sclk_freq": "10.0",
                       "sys_clk_freq": "50"})],
                    [("clock", "clk_0.clk", "mega.clk"),
                     ("reset", "clk_0.clk_reset", "mega.reset")],
                    [("readings", "mega.readings"), ("external", "mega.external_interface")],
                    """module top(input MAX10_CLK1_50, input [9:0] SW, output [9:0] LEDR);
wire [11:0] first, last;
sys system(.clk_clk(MAX10_CLK1_50), .reset_reset_n(1'b1), .readings_CH0(first), .readings_CH5(last),
    .external_dout(1'b0));
assign LEDR = first[11:2] ^ last[11:2];
endmodule
""")
        self.volts(0, 2, 1638)
        self.volts(5, 1, 819)

    # With registers: a value that was asked for, then those that come by themselves.
    def test_of_the_university_program_has_registers(self):
        self.system([("adc", "altera_up_avalon_adc", {"board": "DE10-Lite", "numch_": "6",
                                                      "AUTO_CLK_CLOCK_RATE": "50000000"})],
                    [("clock", "clk_0.clk", "adc.clk"), ("reset", "clk_0.clk_reset", "adc.reset")],
                    [("regs", "adc.adc_slave"), ("pins", "adc.external_interface")],
                    """module top(input MAX10_CLK1_50, input [9:0] SW, output reg [9:0] LEDR);
reg [7:0] n = 0; reg read = 0; wire waits; wire [31:0] data;
sys system(.clk_clk(MAX10_CLK1_50), .reset_reset_n(1'b1),
    .regs_address(read ? 3'd2 : {2'd0, SW[0]}), .regs_read(read), .regs_write(n == 8'd200),
    .regs_writedata(32'd1), .regs_readdata(data),
    .regs_waitrequest(waits), .pins_dout(1'b0));
always @(posedge MAX10_CLK1_50) begin
    n <= n + 1;
    if (n == 8'd201) read <= 1;
    if (read && !waits) begin read <= 0; if (data[15] == SW[0]) LEDR <= data[11:2]; end
end
endmodule
""")
        self.volts(2, 3, 2457)
        self.plays("hold: {switch: 0}", "set-voltage: {channel: 2, volts: 1}", "delay: 1ms",
                   f'expect-leds: "{819 >> 2:010b}"', project="p.qsf")

    def test_with_limits_is_refused(self):
        self.system([("pll", "altpll", PLL), ("adc", "altera_modular_adc", {"CORE_VAR": "1"})],
                    CLOCKS, [], "module top(input MAX10_CLK1_50); sys system(); endmodule\n")
        self.refused("CORE_VAR is 1, threshold violation detection, which is not simulated",
                     "check", "p.qsf")


run()
