"""computer_test.py DE1SIM FOLDER [CASE...] - what the DE1-SoC Computer's system has besides"""
from case import run
from systems import FULL, LW, SystemCase

NIOS = [("cpu", "altera_nios2_gen2", {}),
        ("floats", "altera_nios_custom_instr_floating_point", {}),
        ("capturer", "intr_capturer", {}),
        ("own", "altera_avalon_onchip_memory2", {"memorySize": "4096", "dataWidth": "32"})]
NIOS_WIRES = [("clock", "clk_0.clk", "cpu.clk"), ("reset", "clk_0.clk_reset", "cpu.reset"),
              ("avalon", "cpu.data_master", "leds.s1", 0x10),
              ("clock", "clk_0.clk", "own.clk1"), ("reset", "clk_0.clk_reset", "own.reset1"),
              ("avalon", "cpu.data_master", "own.s1", 0x2000),
              ("nios_custom_instruction", "cpu.custom_instruction_master", "floats.s1")]


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
        wires += [("clock", "clk_0.clk", "windows.clock"),
                  ("reset", "clk_0.clk_reset", "windows.reset"),
                  ("avalon", FULL, "windows.windowed_slave", 0x1000),
                  ("avalon", FULL, "m1.s1", 0x2000)]
        if parameters.get("ENABLE_SLAVE_PORT") != "false":
            wires.append(("avalon", LW, "windows.cntl", 0x100))
        self.with_leds(modules, wires)
        self.program("volatile uint32_t* w = (volatile uint32_t*)0xC0001000;\n"
                     "volatile uint32_t* c = (volatile uint32_t*)0xFF200100;\n" + body)
        self.shows(0x155)

    def test_two_windows_go_where_they_are_told(self):
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
    def serial(self, kind, body, *steps, top, ports="", more=(), wires=(), exports=(),
               **parameters):
        self.with_leds([("port", f"altera_up_avalon_{kind}",
                         {"AUTO_CLK_CLOCK_RATE": "50000000", **parameters}), *more],
                       [*wires, ("clock", "clk_0.clk", "port.clk"),
                        ("reset", "clk_0.clk_reset", "port.reset"),
                        ("interrupt", "hps_0.f2h_irq0", "port.interrupt", 9),
                        ("avalon", LW, f"port.avalon_{kind}_slave", 0x40)],
                       exports=[("port", "port.external_interface"), *exports], top=top,
                       ports=ports)
        self.program("#define DATA R32(0xFF200040)\n#define CONTROL R32(0xFF200044)\n"
                     "#define LEDS R32(0xFF200000)\nuint32_t d;\n" + body)
        self.write(s_yaml="name: s\nversion: 1\nprogram: program.elf\nproject: top.qsf\nsteps:\n" +
                          "".join(f"  - {step}\n" for step in steps))
        return self.de1sim("run", "s.yaml")

    def looped(self, body, **parameters):
        done = self.serial("rs232", body, "expect-leds: {equals: 341, timeout: 40ms}",
                           top=", .port_RXD(GPIO_0[0]), .port_TXD(GPIO_0[0])",
                           ports=", inout [35:0] GPIO_0", **parameters)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

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
            done = self.serial("rs232", f"""uint32_t ok = 1;
for (int n = 0; n < 8; n++) DATA = (1 << n) - 1;
for (int n = 0; n < 8; n++) {{
    while (!((d = R32(0xFF200080)) & 0x8000)) {{}}
    ok &= (d & 0x3FF) == ((1 << n) - 1 | ((n & 1) ^ {odd}) << 8);
}}
LEDS = ok ? 341 : 1;""", "expect-leds: {equals: 341, timeout: 40ms}",
                               more=[("other", "altera_up_avalon_rs232", other)],
                               wires=[("clock", "clk_0.clk", "other.clk"),
                                      ("reset", "clk_0.clk_reset", "other.reset"),
                                      ("avalon", LW, "other.avalon_rs232_slave", 0x80)],
                               exports=[("other", "other.external_interface")],
                               top=", .port_RXD(1'b1), .port_TXD(GPIO_0[0]), "
                                   ".other_RXD(GPIO_0[0])",
                               ports=", inout [35:0] GPIO_0", parity=parity)
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

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
        done = self.serial("irda", "CONTROL = 1;\nwhile (!(R32(0xFFFED208) & 0x20000)) {}\n"
                           "d = DATA; if (d >> 16 >= 96 && (d & 0x83FF) == 0x8000) LEDS = 341;\n",
                           "press-remote: 5", "expect-leds: {equals: 341, timeout: 60ms}",
                           top=", .port_RXD(IRDA_RXD), .port_TXD(IRDA_TXD)",
                           ports=", input IRDA_RXD, output IRDA_TXD")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_pulses_are_bytes(self):
        done = self.serial("irda", "for (int n = 0; n < 9; n++) DATA = 0x5A + n;\n"
                           "uint32_t ok = 1; for (int n = 0; n < 9; n++) {\n"
                           "while (!((d = DATA) & 0x8000)) {} ok &= (d & 0x3FF) == 0x5A + n; }\n"
                           "LEDS = ok ? 341 : 1;\n",
                           "expect-leds: {equals: 341, timeout: 20ms}",
                           top=", .port_RXD(!GPIO_0[0]), .port_TXD(GPIO_0[0])",
                           ports=", inout [35:0] GPIO_0")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_streams_are_refused(self):
        done = self.serial("rs232", "", "delay: 1ms", top="", avalon_bus_type="Streaming")
        self.assertEqual(done.returncode, 2)
        self.assertIn('avalon_bus_type is "Streaming"', done.stderr)


if __name__ == "__main__":
    run()
