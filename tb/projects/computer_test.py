"""computer_test.py DE1SIM FOLDER [CASE...] - serial ports, windows, resets and a Nios in systems"""
from case import run
from systems import FULL, LW, SystemCase, clocked, qsys

NIOS = [("cpu", "altera_nios2_gen2", {}),
        ("floats", "altera_nios_custom_instr_floating_point", {}),
        ("capturer", "intr_capturer", {}),
        ("own", "altera_avalon_onchip_memory2", {"memorySize": "4096", "dataWidth": "32"})]
NIOS_WIRES = [*clocked("cpu"),
              ("avalon", "cpu.data_master", "leds.s1", 0x10),
              *clocked("own", "clk1", "reset1"),
              ("avalon", "cpu.data_master", "own.s1", 0x2000),
              ("nios_custom_instruction", "cpu.custom_instruction_master", "floats.s1")]
TERMINAL = "parts:\n  - terminal: {name: pc, rx: 'GPIO_0[1]', tx: 'GPIO_0[0]'}\n"


class Nios(SystemCase):
    def test_a_nios_beside_the_arm_is_left_out(self):
        self.with_leds(NIOS, NIOS_WIRES)
        self.program("R32(0xFF200000) = 5;")
        said = self.shows(5).stderr
        self.assertIn("left out, since a Nios cannot be simulated: cpu (altera_nios2_gen2), "
                      "floats (altera_nios_custom_instr_floating_point)\n", said)
        self.assertIn("left out, for a computer at the JTAG port: capturer (intr_capturer)\n", said)


class AddressSpanExtender(SystemCase):
    def extended(self, body, **parameters):
        """Two memories of 4 KB at 0 and at 0x8000000 of a master with windows of 4 KB in all."""
        memory = {"memorySize": "4096", "dataWidth": "32", "initMemContent": "false"}
        modules, wires = [], []
        for n in (0, 1):
            modules.append((f"m{n}", "altera_avalon_onchip_memory2", memory))
            wires += [("clock", "clk_0.clk", f"m{n}.clk1"),
                      ("reset", "clk_0.clk_reset", f"m{n}.reset1"),
                      ("avalon", "windows.expanded_master", f"m{n}.s1", n << 27)]
        modules.append(("windows", "altera_address_span_extender",
                        {"SLAVE_ADDRESS_WIDTH": "10", **parameters}))
        wires += [*clocked("windows", "clock"),
                  ("avalon", FULL, "windows.windowed_slave", 0x1000),
                  ("avalon", FULL, "m1.s1", 0x2000)]
        if parameters.get("ENABLE_SLAVE_PORT") != "false":
            wires.append(("avalon", LW, "windows.cntl", 0x100))
        self.with_leds(modules, wires)
        self.program("volatile uint32_t* w = (volatile uint32_t*)0xC0001000;\n"
                     "volatile uint32_t* c = (volatile uint32_t*)0xFF200100;\n" + body)
        self.shows(0x155)

    def test_two_windows_go_where_they_are_sent(self):
        self.extended("""c[0] = 0xFFFFFFFF; c[1] = 0xFFFFFFFF;
uint32_t ok = c[0] == 0xFFFFF800 && c[1] == 0 && c[2] == 0;
c[0] = 0x08000000; c[2] = 0x08000800;
w[5] = 1; w[0x205] = 2;
c[0] = 0; w[5] = 3; w[0x205] = 4; c[2] = 0x08000000;
ok &= w[5] == 3 && w[0x205] == 1;
c[0] = 0x08000800; ok &= w[5] == 4;
R32(0xFF200000) = ok ? 0x155 : 0;""", SUB_WINDOW_COUNT="2")

    def test_a_window_that_stays_is_where_platform_designer_put_it(self):
        self.extended("""w[0x3FF] = 7; R8(0xC0001001) = 9;
R32(0xFF200000) = R32(0xC0002FFC) == 7 && (R32(0xC0002000) & 0xFF00) == 0x900 ? 0x155 : 0;""",
                      ENABLE_SLAVE_PORT="false", MASTER_ADDRESS_DEF="134217728")

    def test_three_windows_are_refused(self):
        self.with_leds([("w", "altera_address_span_extender", {"SUB_WINDOW_COUNT": "3"})])
        self.refused("SUB_WINDOW_COUNT is 3, expected a power of 2", "check", "top.qsf")


class Serial(SystemCase):
    def serial(self, kind, body, *steps, top, ports="", more=(), wires=(), exports=(), code=0,
               **parameters):
        self.with_leds([("port", f"altera_up_avalon_{kind}",
                         {"AUTO_CLK_CLOCK_RATE": "50000000", **parameters}), *more],
                       [*wires, *clocked("port"),
                        ("interrupt", "hps_0.f2h_irq0", "port.interrupt", 9),
                        ("avalon", LW, f"port.avalon_{kind}_slave", 0x40)],
                       exports=[("port", "port.external_interface"), *exports], top=top,
                       ports=ports)
        self.program("#define DATA R32(0xFF200040)\n#define CONTROL R32(0xFF200044)\n"
                     "#define LEDS R32(0xFF200000)\nuint32_t d;\n" + body)
        return self.played(*steps, code=code)

    def looped(self, body, **parameters):
        self.serial("rs232", body, "expect-leds: {equals: 341, timeout: 40ms}",
                    top=", .port_RXD(GPIO_0[0]), .port_TXD(GPIO_0[0])",
                    ports=", inout [35:0] GPIO_0", **parameters)

    def test_bytes_come_back_in_their_order(self):
        self.looped("""uint32_t ok = CONTROL == 0x00800000 && DATA >> 15 == 0;
for (int n = 0; n < 128; n++) DATA = n * 7;
ok &= CONTROL >> 16 < 2;
for (int n = 0; n < 128; n++) {
    while (!((d = DATA) & 0x8000)) {}
    ok &= (d & 0x3FF) == (n * 7 & 0xFF);
}
LEDS = ok ? 341 : 1;""")

    def test_nine_bits_with_parity(self):
        for parity in "Odd", "Even":
            self.looped("""uint32_t ok = 1;
for (int n = 0; n < 5; n++) DATA = 0x1FE << n;
for (int n = 0; n < 5; n++) {
    while (!((d = DATA) & 0x8000)) {}
    ok &= (d & 0x3FF) == (0x1FE << n & 0x1FF);
}
LEDS = ok ? 341 : 1;""", data_bits="9", stop_bits="2", parity=parity, baud="921600")

    # A second port without parity takes the parity bit for its ninth.
    def test_parity_is_odd_or_even(self):
        for parity, odd in ("Odd", 1), ("Even", 0):
            other = {"AUTO_CLK_CLOCK_RATE": "50000000", "data_bits": "9"}
            self.serial("rs232", f"""uint32_t ok = 1;
for (int n = 0; n < 8; n++) DATA = (1 << n) - 1;
for (int n = 0; n < 8; n++) {{
    while (!((d = R32(0xFF200080)) & 0x8000)) {{}}
    ok &= (d & 0x3FF) == ((1 << n) - 1 | ((n & 1) ^ {odd}) << 8);
}}
LEDS = ok ? 341 : 1;""", "expect-leds: {equals: 341, timeout: 40ms}",
                        more=[("other", "altera_up_avalon_rs232", other)],
                        wires=[*clocked("other"),
                               ("avalon", LW, "other.avalon_rs232_slave", 0x80)],
                        exports=[("other", "other.external_interface")],
                        top=", .port_RXD(1'b1), .port_TXD(GPIO_0[0]), "
                            ".other_RXD(GPIO_0[0])",
                        ports=", inout [35:0] GPIO_0", parity=parity)

    def test_interrupts_wait_for_many_bytes_or_much_room(self):
        self.looped("""#define IRQ (R32(0xFFFED208) >> 17 & 1)
for (int n = 0; n < 95; n++) DATA = n;
uint32_t ok = 1;
while (CONTROL >> 16 != 128) {}
for (int n = 0; n < 5000; n++) ok &= !IRQ;
CONTROL = 2; ok &= CONTROL == 0x00800202 && IRQ;
CONTROL = 1; ok &= CONTROL == 0x00800001; DATA = 1;
while (!IRQ) {}
ok &= CONTROL == 0x00800101 && DATA >> 16 == 96;
LEDS = ok && !IRQ ? 341 : 1;""", baud="921600")

    def test_a_remote_control_is_zeros(self):
        self.serial("irda", "CONTROL = 1;\nwhile (!(R32(0xFFFED208) & 0x20000)) {}\n"
                    "d = DATA; if (d >> 16 >= 96 && (d & 0x83FF) == 0x8000) LEDS = 341;\n",
                    "press-remote: 5", "expect-leds: {equals: 341, timeout: 60ms}",
                    top=", .port_RXD(IRDA_RXD), .port_TXD(IRDA_TXD)",
                    ports=", input IRDA_RXD, output IRDA_TXD")

    def test_pulses_are_bytes(self):
        self.serial("irda", "for (int n = 0; n < 9; n++) DATA = 0x5A + n;\n"
                    "uint32_t ok = 1; for (int n = 0; n < 9; n++) {\n"
                    "while (!((d = DATA) & 0x8000)) {} ok &= (d & 0x3FF) == 0x5A + n; }\n"
                    "LEDS = ok ? 341 : 1;\n",
                    "expect-leds: {equals: 341, timeout: 20ms}",
                    top=", .port_RXD(!GPIO_0[0]), .port_TXD(GPIO_0[0])",
                    ports=", inout [35:0] GPIO_0")

    def test_streams_are_refused(self):
        done = self.serial("rs232", "", "delay: 1ms", top="", code=2, avalon_bus_type="Streaming")
        self.assertIn('avalon_bus_type is "Streaming"', done.stderr)


class Rates(SystemCase):
    def test_a_rate_that_the_file_has_not_is_the_plls(self):
        """In a subsystem the file says 0: the port is 100 MHz' all the same."""
        self.write(inner_qsys=qsys([("clock", "clock_source", {"clockFrequency": "50000000"}),
                                    ("port", "altera_up_avalon_rs232",
                                     {"AUTO_CLK_CLOCK_RATE": "0"})],
                                   [("clock", "clock.clk", "port.clk"),
                                    ("reset", "clock.clk_reset", "port.reset")],
                                   [("clk", "clock.clk_in"), ("reset", "clock.clk_in_reset"),
                                    ("slave", "port.avalon_rs232_slave"),
                                    ("pins", "port.external_interface")], clock=""))
        self.with_leds([("pll", "altera_up_avalon_sys_sdram_pll", {"gui_outclk": "100.0"}),
                        ("inner", "inner", {})],
                       [*clocked("pll", "ref_clk", "ref_reset"),
                        ("clock", "pll.sys_clk", "inner.clk"),
                        ("reset", "pll.reset_source", "inner.reset"),
                        ("avalon", LW, "inner.slave", 0x40)],
                       exports=[("pins", "inner.pins")],
                       top=", .pins_RXD(GPIO_0[0]), .pins_TXD(GPIO_0[1])",
                       ports=", inout [35:0] GPIO_0")
        self.program("uint32_t d; for (;;) if ((d = R32(0xFF200040)) & 0x8000)\n"
                     "R32(0xFF200040) = (d & 0xFF) + 1;\n")
        self.played("type-serial: {to: pc, text: HAL}",
                    "wait-serial: {on: pc, text: IBM, timeout: 20ms}", head=TERMINAL)


class Uart(SystemCase):
    def uart(self, body, *steps, top="", ports=", inout [35:0] GPIO_0", parts="", **parameters):
        top = top or ", .port_rxd(GPIO_0[0]), .port_txd(GPIO_0[0])"
        self.with_leds([("port", "altera_avalon_uart", {"clockRate": "50000000", **parameters})],
                       [*clocked("port"),
                        ("interrupt", "hps_0.f2h_irq0", "port.irq", 9),
                        ("avalon", LW, "port.s1", 0x40)],
                       exports=[("port", "port.external_connection")], top=top, ports=ports)
        self.program("volatile uint16_t* u = (volatile uint16_t*)0xFF200040;\n"
                     "enum { RX = 0, TX = 2, STATUS = 4, CONTROL = 6, DIVISOR = 8, EOP = 10 };\n"
                     "#define IRQ (R32(0xFFFED208) >> 17 & 1)\nuint32_t ok = 1;\n" + body +
                     "R32(0xFF200000) = ok ? 341 : 1;")
        steps = steps or ("expect-leds: {equals: 341, timeout: 40ms}",)
        self.played(*steps, head=parts)

    def test_a_terminal_is_answered(self):
        self.uart("for (;;) { while (!(u[STATUS] & 0x80)) {} uint16_t c = u[RX];\n"
                  "while (!(u[STATUS] & 0x40)) {} u[TX] = c + 1; }\n",
                  "type-serial: {to: pc, text: HAL}",
                  "wait-serial: {on: pc, text: IBM, timeout: 20ms}",
                  parts=TERMINAL,
                  top=", .port_rxd(GPIO_0[0]), .port_txd(GPIO_0[1])")

    def test_status_follows_what_goes_and_comes(self):
        self.uart("""ok &= u[STATUS] == 0x60; u[TX] = 0x55;
while (!(u[STATUS] & 0x40)) {} u[TX] = 0xAA; ok &= (u[STATUS] & 0x160) == 0;
u[TX] = 0x33; ok &= (u[STATUS] & 0x110) == 0x110;
u[STATUS] = 0; ok &= (u[STATUS] & 0x110) == 0;
while (!(u[STATUS] & 0x80)) {} ok &= u[RX] == 0x55 && !(u[STATUS] & 0x80);
while (!(u[STATUS] & 0x20)) {} ok &= u[RX] == 0x33 && u[STATUS] == 0x60;
u[TX] = 1; while (!(u[STATUS] & 0x80)) {} u[TX] = 2; while (!(u[STATUS] & 0x20)) {}
while (!(u[STATUS] & 8)) {} ok &= (u[STATUS] & 0x1FF) == 0x1E8 && u[RX] == 2;
""")

    def test_interrupts_and_the_end_of_a_packet(self):
        self.uart("""u[EOP] = 10; u[CONTROL] = 0x80; ok &= !IRQ; u[TX] = 9;
while (!IRQ) {} ok &= u[RX] == 9 && !IRQ && !(u[STATUS] & 0x1000);
u[CONTROL] = 0x1000; u[TX] = 10; ok &= IRQ && u[STATUS] >> 12 == 1;
u[STATUS] = 0; ok &= !IRQ; while (!(u[STATUS] & 0x80)) {} ok &= IRQ;
u[CONTROL] = 0x40; ok &= IRQ; u[CONTROL] = 0x100; ok &= !IRQ;
""", useEopRegister="true")

    def test_a_break_is_an_error_of_the_frame(self):
        self.uart("""u[CONTROL] = 0x300; ok &= !IRQ;
while (!(u[STATUS] & 0x80)) {} ok &= (u[STATUS] & 0x1FF) == 0x1E6 && IRQ && u[RX] == 0;
for (int n = 0; n < 20000; n++) ok &= !(u[STATUS] & 0x80);
u[CONTROL] = 0; u[STATUS] = 0; u[TX] = 7; while (!(u[STATUS] & 0x80)) {}
ok &= u[RX] == 7 && (u[STATUS] & 0x1F) == 0;
""", parity="EVEN")

    def test_the_rate_is_the_divisors(self):
        self.uart("""ok &= u[DIVISOR] == 433; u[DIVISOR] = 49; ok &= u[DIVISOR] == 49;
for (int n = 0; n < 100; n++) { u[TX] = 3 * n & 0x7F; while (!(u[STATUS] & 0x80)) {}
    ok &= u[RX] == (3 * n & 0x7F); }
""", "expect-leds: {equals: 341, timeout: 1300us}", fixedBaud="false", dataBits="7", parity="ODD")

    def test_a_line_to_ask_before_sending(self):
        self.uart("""ok &= (u[STATUS] & 0x0C00) == 0; u[CONTROL] = 0x800;
while (!(u[STATUS] & 0x400)) {} ok &= u[STATUS] >> 10 == 3;
u[STATUS] = 0; ok &= u[STATUS] >> 10 == 2;
u[CONTROL] = 0x400; ok &= !IRQ; while (!IRQ) {} ok &= u[STATUS] >> 10 == 1;
""", useCtsRts="true", top=", .port_rxd(1'b1), .port_txd(), .port_cts_n(GPIO_0[0]), "
                           ".port_rts_n(GPIO_0[0])")


class ParallelPort(SystemCase):
    def port(self, body, *steps, top, ports="", leds=341, **parameters):
        irq = [("interrupt", "hps_0.f2h_irq0", "port.interrupt", 9)] if "irq" in parameters else []
        self.with_leds([("port", "altera_up_avalon_parallel_port",
                         {"custom_port": "true", **parameters})],
                       [*clocked("port"), *irq,
                        ("avalon", LW, "port.avalon_parallel_port_slave", 0x40)],
                       exports=[("port", "port.external_interface")],
                       top=f", .port_export({top})", ports=ports)
        self.program("volatile uint32_t* p = (volatile uint32_t*)0xFF200040;\n"
                     "#define LEDS R32(0xFF200000)\n#define IRQ (R32(0xFFFED208) >> 17 & 1)\n" +
                     body)
        self.played(*steps, f"expect-leds: {{equals: {leds}, timeout: 10ms}}")

    def test_an_input_interrupts_at_edges(self):
        self.port("p[2] = 3; while (!IRQ) {} uint32_t e = p[3]; p[3] = 0x80;\n"
                  "LEDS = e == 0x22 && p[3] == 0 && !IRQ && (p[0] & 2) && p[2] == 3 ? 341 : e;\n",
                  "delay: 1ms", "hold: {switch: [1, 5], bounce: 0us}", top="SW", custom_DW="10",
                  capture="true",
                  irq="true", irq_type="Edge")

    def test_bytes_of_an_output(self):
        self.port("p[0] = 0xFFFFFF; R8(0xFF200041) = 0x12;\n"
                  "LEDS = p[0] == 0xFF12FF && p[1] == 0 ? 341 : 1;\n", top="", custom_DW="24",
                  custom_direction="Output only")

    def test_pins_in_both_directions(self):
        self.port("p[1] = 1; p[0] = 1; uint32_t high = p[0] & 3, d = p[1]; p[0] = 0;\n"
                  "for (int n = 0; n < 9; n++) d |= (p[0] & 3) << 8;\n"
                  "LEDS = high == 3 && d == 1 ? 341 : 1;\n",
                  top="pins", ports=");\nwire [1:0] pins; assign pins[1] = pins[0]; wire unused"
                                    " = (1'b1", custom_DW="2", custom_direction="Bidirectional")

    def test_a_preset_is_refused(self):
        self.with_leds([("port", "altera_up_avalon_parallel_port", {})])
        self.refused("it is preset for Pushbuttons, of which only a custom port can be simulated",
                     "check", "top.qsf")


class ResetController(SystemCase):
    def test_a_reset_of_two(self):
        """The PIO falls back to its value when the top resets it by the controller."""
        self.with_leds([("both", "altera_reset_controller", {"NUM_RESET_INPUTS": "2"}),
                        ("also", "clock_source", {}),
                        ("held", "altera_avalon_pio", {"width": "10", "direction": "Output",
                                                       "resetValue": "7"})],
                       [*clocked("both", "clk", "reset_in0"),
                        ("reset", "also.clk_reset", "both.reset_in1"),
                        ("clock", "clk_0.clk", "held.clk"),
                        ("reset", "both.reset_out", "held.reset"), ("avalon", LW, "held.s1", 0x40)],
                       exports=[("also_clk", "also.clk_in"), ("also", "also.clk_in_reset"),
                                ("held", "held.external_connection")],
                       top=", .also_clk_clk(CLOCK_50), .also_reset_n(!SW[0]), .held_export()")
        self.program("volatile uint32_t* held = (volatile uint32_t*)0xFF200040;\n"
                     "uint32_t n = held[0]; held[0] = 5;\n"
                     "for (;;) R32(0xFF200000) = n << 4 | held[0];\n")
        self.played("expect-leds: {equals: 117, timeout: 1ms}", "hold: {switch: 0}",
                    "release: {switch: 0}", "expect-leds: {equals: 119, timeout: 10ms}")


if __name__ == "__main__":
    run()
