"""systems_test.py DE1SIM FOLDER [CASE...] - Platform Designer systems, with a program on them"""
from case import run
from systems import (BASE, CLOCKS, FULL, HPS, HW_TCL, LW, OWN_CLOCK, TOP, SystemCase, clocked, pio,
                     qsys)

# A component with an array of words behind a slave of the timing that is asked for.
STORE_TCL = HW_TCL + "add_interface s avalon end\n" + OWN_CLOCK + """\
{properties}
add_interface_port s address address Input 4
add_interface_port s write write Input 1
add_interface_port s read read Input 1
add_interface_port s writedata writedata Input {width}
add_interface_port s readdata readdata Output {width}
{ports}
"""


class Systems(SystemCase):
    # ---- What runs --------------------------------------------------------

    def test_a_warm_reset_of_the_processor_resets_the_design(self):
        """By the reset manager; the LEDs' register is cleared, and begins again."""
        leds, wires = pio("leds", 0)
        wires = [("reset", "hps_0.h2f_reset", "leds.reset") if kind == "reset" else
                 (kind, *more) for kind, *more in wires]
        self.system(leds, wires, [("leds", "leds.external_connection"),
                                  ("h2f", "hps_0.h2f_reset")],
                    ", .leds_export(leds), .h2f_reset_n(rst_n)",
                    "); wire rst_n; wire [9:0] leds; reg [3:0] resets = 0; reg [8:0] clocks = 0;\n"
                    "always @(negedge rst_n) resets <= resets + 1;\n"
                    "always @(posedge CLOCK_50) if (!rst_n) clocks <= clocks + 1;\n"
                    "wire right = clocks >= 254 && clocks <= 258;\n"
                    "assign LEDR = {resets, right, leds[4:0]}; wire unused = (1'b0")
        self.program("""if (R32(0xFFD05000) & 1 << 10) { R32(0xFF200000) |= 2; for (;;) {} }
R32(0xFF200000) = 1;
R32(0xFFD05004) = 2;""")
        self.shows(0b0001_1_00010)

    def test_every_width_and_timing_holds_what_was_written(self):
        modules, wires, files, body = [], [], {}, "uint32_t bad = 0;\n"
        kinds = [(8, "set_interface_property s readWaitTime 1", "", "read_data", 0),
                 (16, "set_interface_property s readWaitTime 3\n"
                      "set_interface_property s writeWaitTime 2\n"
                      "set_interface_property s setupTime 1\n"
                      "set_interface_property s holdTime 1", "", "read_data", 0),
                 (32, "set_interface_property s readWaitTime 0\n"
                      "set_interface_property s readLatency 2", "", "later", 0),
                 (64, "", "add_interface_port s waitrequest waitrequest Output 1\n"
                          "add_interface_port s byteenable byteenable Input 8", "read_data", 1),
                 (32, "set_interface_property s maximumPendingReadTransactions 4",
                  "add_interface_port s readdatavalid readdatavalid Output 1\n"
                  "add_interface_port s waitrequest waitrequest Output 1\n"
                  "add_interface_port s byteenable byteenable Input 4", "valid", 1)]
        for n, (width, properties, ports, form, waits) in enumerate(kinds):
            name = f"store{n}"
            byte_enable = "byteenable" in ports
            text = STORE_TCL.format(name=name, width=width, properties=properties, ports=ports)
            (self.folder / f"{name}_hw.tcl").write_text(text)
            bytes_ = width // 8
            write = "".join(f"if (be[{i}]) words[address][{8 * i} +: 8] <= "
                            f"writedata[{8 * i} +: 8];\n" for i in range(bytes_))
            (self.folder / f"{name}.v").write_text(f"""module {name}(input clk, input reset,
input [3:0] address, input write, input read, input [{width - 1}:0] writedata,
output [{width - 1}:0] readdata
{", output waitrequest" if waits else ""}{", output readdatavalid" if form == "valid" else ""}
{f", input [{bytes_ - 1}:0] byteenable" if byte_enable else ""});
wire [{bytes_ - 1}:0] be = {"byteenable" if byte_enable else f"{{{bytes_}{{1'b1}}}}"};
reg [{width - 1}:0] words [0:15];
reg [2:0] count = 0;
always @(posedge clk) count <= count + 1;
{"assign waitrequest = count[1:0] != 2'd3;" if waits else ""}
wire taken = {"!waitrequest" if waits else "1'b1"};
always @(posedge clk) if (write && taken) begin
{write}end
reg [{width - 1}:0] q1, q2, q3;
reg [2:0] line = 0;
always @(posedge clk) begin
    q1 <= words[address]; q2 <= q1; q3 <= q2;
    line <= {{line[1:0], read && taken}};
end
{"assign readdatavalid = line[2];" if form == "valid" else ""}
assign readdata = {"words[address]" if form == "read_data" else "q2" if form == "later" else "q3"};
endmodule
""")
            modules.append((name, name, {}))
            base = 0x100 * (n + 1)
            for bridge in (LW, FULL):
                wires.append(("avalon", bridge, f"{name}.s", base))
            wires += [*clocked(name, "clock")]
            # By both bridges, in every width that the slave's byte lanes allow.
            sizes = [8, 16, 32, 64] if width == 8 or byte_enable else \
                    [size for size in (8, 16, 32, 64) if size >= width]
            for bridge in (0xFF200000, 0xC0000000):
                for size in sizes:
                    body += f"""for (uint32_t n = 0; n < {16 * bytes_ // (size // 8)}; ++n)
    R{size}({bridge + base:#x} + n * {size // 8}) =
        (uint{size}_t)((n + {size}) * 0x1020408040201ull);
for (uint32_t n = 0; n < {16 * bytes_ // (size // 8)}; ++n)
    if (R{size}({bridge + base:#x} + n * {size // 8}) !=
        (uint{size}_t)((n + {size}) * 0x1020408040201ull)) bad |= 1u << {n};
"""
        self.with_leds(modules, wires, **files)
        self.program(body + "R32(0xFF200000) = bad ? bad : 0x3FF;")
        self.shows(0x3FF)

    def test_a_slave_on_another_clock_of_two_masters(self):
        modules = [("memory", "altera_avalon_onchip_memory2",
                    {"dataWidth": "16", "memorySize": "1024", "initMemContent": "false"}),
                   ("slow", "clock_source", {})]
        wires = [("clock", "slow.clk", "memory.clk1"),
                 ("reset", "slow.clk_reset", "memory.reset1"),
                 ("avalon", LW, "memory.s1", 0x400), ("avalon", FULL, "memory.s1", 0)]
        leds, of_leds = pio("leds", 0)
        self.system([*leds, *modules], [*of_leds, *wires],
                    [("leds", "leds.external_connection"), ("slow", "slow.clk_in"),
                     ("slow_reset", "slow.clk_in_reset")],
                    ", .leds_export(LEDR), .slow_clk(slow), .slow_reset_reset_n(1'b1)")
        top = (self.folder / "top.v").read_text()
        (self.folder / "top.v").write_text(top.replace(
            "sys system", "reg slow = 0; reg [1:0] n = 0;\n"
            "always @(posedge CLOCK_50) begin n <= n == 2 ? 0 : n + 1; if (n == 2) slow <= !slow; "
            "end\nsys system"))
        self.program("for (uint32_t n = 0; n < 256; ++n) R32(0xC0000000 + 4 * n) = n * 0x10003;\n"
                     "uint32_t good = 1;\n"
                     "for (uint32_t n = 0; n < 256; ++n) good &= R32(0xFF200400 + 4 * n) == "
                     "n * 0x10003;\nR32(0xFF200000) = good ? 5 : 2;")
        self.shows(5)

    def test_the_sdram_by_the_university_programs_pll(self):
        modules = [("clk_0", "clock_source", {}), ("hps_0", "altera_hps", HPS),
                   ("pll", "altera_up_avalon_sys_sdram_pll", {"gui_outclk": "100.0"}),
                   ("sdram", "altera_avalon_new_sdram_controller", {"clockRate": "100000000"}),
                   ("leds", "altera_avalon_pio", {"width": "10", "direction": "Output"})]
        wires = [*clocked("pll", "ref_clk", "ref_reset"),
                 *(("clock", "pll.sys_clk", end) for end in (
                     "hps_0.h2f_axi_clock", "hps_0.h2f_lw_axi_clock", "sdram.clk", "leds.clk")),
                 ("reset", "pll.reset_source", "sdram.reset"),
                 ("reset", "pll.reset_source", "leds.reset"),
                 ("avalon", FULL, "sdram.s1", 0), ("avalon", LW, "leds.s1", 0)]
        exports = [("leds", "leds.external_connection"), ("dram", "sdram.wire"),
                   ("dram_clk", "pll.sdram_clk")]
        pins = "".join(f", .dram_{role}(DRAM_{pin})" for role, pin in (
            ("addr", "ADDR"), ("ba", "BA"), ("cas_n", "CAS_N"), ("cke", "CKE"), ("cs_n", "CS_N"),
            ("dq", "DQ"), ("ras_n", "RAS_N"), ("we_n", "WE_N"), ("clk_clk", "CLK")))
        self.system((), (), (), "")
        self.write(sys_qsys=qsys(modules, wires, exports), top_v=f"""module top(input CLOCK_50,
output [9:0] LEDR, output [12:0] DRAM_ADDR, output [1:0] DRAM_BA, output DRAM_CAS_N, DRAM_CKE,
DRAM_CS_N, DRAM_RAS_N, DRAM_WE_N, DRAM_CLK, DRAM_LDQM, DRAM_UDQM, inout [15:0] DRAM_DQ);
sys system(.clk_clk(CLOCK_50), .reset_reset_n(1'b1), .leds_export(LEDR),
           .dram_dqm({{DRAM_UDQM, DRAM_LDQM}}){pins});
endmodule
""")
        self.program("""uint32_t bad = 0;
const uint32_t steps[] = {4, 2048, 4096, 0x100000};
for (unsigned s = 0; s < 4; ++s) {
    for (uint32_t n = 0; n < 60; ++n) R32(0xC0000000 + n * steps[s]) = n * 0x01030507 + s;
    for (uint32_t n = 0; n < 60; ++n)
        if (R32(0xC0000000 + n * steps[s]) != n * 0x01030507 + s) bad |= 1u << s;
}
R64(0xC0000100) = 0x1122334455667788; R8(0xC0000103) = 0xAB; R16(0xC0000106) = 0xCDEF;
if (R64(0xC0000100) != 0xCDEF3344AB667788) bad |= 16;
R32(0xFF200000) = bad ? bad : 0x3FF;""")
        self.shows(0x3FF)
        self.assertEqual(self.report()["sdram_violations"]["count"], 0)

    def timer(self, body, leds, **parameters):
        """A timer of 50 MHz at 0x1000, by interrupt 2; what `body` leaves in `shown`."""
        self.with_leds(
            [("timer_0", "altera_avalon_timer", {"systemFrequency": "50000000", **parameters})],
            [*clocked("timer_0"),
             ("avalon", LW, "timer_0.s1", 0x1000),
             ("interrupt", "hps_0.f2h_irq0", "timer_0.irq", 2)])
        self.program("volatile uint16_t* const T = (volatile uint16_t*)0xFF201000;\n"
                     "#define REG(n) T[(n) * 2]\nuint32_t shown = 0;\n"
                     f"{body}\nR32(0xFF200000) = shown;")
        self.shows(leds)

    def test_a_timer_counts_its_period_and_one_clock(self):
        self.timer("REG(2) = 99; REG(3) = 0; REG(1) = 6;\n"
                   "for (int n = 0; n < 3; n++) { while (!(REG(0) & 1)) {} REG(0) = 0; shown++; }\n"
                   "REG(4) = 0; uint32_t rest = REG(4); if (rest < 100) shown |= 8;\n"
                   "if (REG(0) == 2) shown |= 16; REG(1) = 8; if (REG(0) == 0) shown |= 32;\n"
                   "if (REG(1) == 8 && REG(2) == 99) shown |= 64;", 0b1111011)

    def test_a_timer_begins_with_the_period_of_platform_designer(self):
        """And stops at 0 without CONT, with the interrupt pending."""
        self.timer("if (REG(2) == 0xC34F && REG(3) == 0) shown |= 1; REG(1) = 5;\n"
                   "while (!(R32(0xFFFED208) >> 10 & 1)) {} shown |= 2;\n"
                   "if (REG(0) == 1) shown |= 4; REG(0) = 0;\n"
                   "if (!(R32(0xFFFED208) >> 10 & 1)) shown |= 8;", 0b1111,
                   period="1", periodUnits="MSEC")

    def test_a_timer_of_64_bits(self):
        self.timer("REG(5) = 0; REG(4) = 1; REG(3) = 0; REG(2) = 0; REG(1) = 4; REG(6) = 0;\n"
                   "if (REG(8) == 0 && REG(7) == 0xFFFF && REG(9) == 0) shown |= 1;\n"
                   "if (REG(0) == 2) shown |= 2;", 0b11, counterSize="64")

    def test_a_timer_without_a_frequency(self):
        modules, wires = [("timer_0", "altera_avalon_timer", {})], [
            *clocked("timer_0"),
            ("avalon", LW, "timer_0.s1", 0x1000)]
        self.refuses("systemFrequency is 0", modules, wires)

    def jtag_uart(self, body, leds, *steps):
        self.with_leds(
            [("jtag", "altera_avalon_jtag_uart", {"simInputCharacterStream": "a &quot;b&quot;"})],
            [*clocked("jtag"),
             ("avalon", LW, "jtag.avalon_jtag_slave", 0x1000),
             ("interrupt", "hps_0.f2h_irq0", "jtag.irq", 8)])
        self.program("#define DATA R32(0xFF201000)\n#define CONTROL R32(0xFF201004)\n"
                     f"uint32_t shown = 0;\n{body}\nR32(0xFF200000) = shown;")
        return self.shows(leds, steps=steps)

    def test_a_jtag_uart_prints_and_is_typed_at(self):
        done = self.jtag_uart(
            "for (const char* s = \"Hello, 1234567 and a line longer than the FIFO of sixty-four "
            "bytes\\n\"; *s; s++) { while (CONTROL >> 16 == 0) {} DATA = *s; }\n"
            "uint32_t d, n = 0; char text[3];\n"
            "while (n < 3) if ((d = DATA) & 0x8000) text[n++] = d;\n"
            "if (text[0] == 'x' && text[1] == 'y' && text[2] == 'z') shown = 0x155;", 0x155,
            'wait-serial: {text: "sixty-four bytes", timeout: 50ms}',
            'type-serial: {text: "xyz", to: jtag-0}')
        self.assertIn("Hello, 1234567 and a line longer than the FIFO", done.stdout)

    def test_a_full_jtag_uart_drops_and_interrupts(self):
        self.jtag_uart(
            "for (int n = 0; n < 70; n++) DATA = 'a';\n"
            "if (CONTROL >> 16 == 0 && CONTROL >> 14 & 1) shown |= 1;\n"
            "if (!(R32(0xFFFED208) >> 16 & 1)) shown |= 2; CONTROL = 2;\n"
            "while (!(R32(0xFFFED208) >> 16 & 1)) {} if (CONTROL >> 9 & 1) shown |= 4;\n"
            "if (CONTROL >> 16 == 64) shown |= 8; CONTROL = 0x402;\n"
            "if (!(CONTROL >> 10 & 1)) shown |= 16;", 0b11111)

    def bridged(self, kind, parameters, clocks):
        """LEDs and a memory of 16 bits behind a bridge at 0x1000."""
        modules = [("bridge", kind, {"ADDRESS_WIDTH": "9", **parameters}),
                   ("leds", "altera_avalon_pio", {"width": "10", "direction": "Output"}),
                   ("memory", "altera_avalon_onchip_memory2",
                    {"dataWidth": "16", "memorySize": "256"})]
        wires = [("avalon", LW, "bridge.s0", 0x1000), ("avalon", "bridge.m0", "leds.s1", 0x100),
                 ("avalon", "bridge.m0", "memory.s1", 0)]
        for end, clock in clocks.items():
            wires += [("clock", clock, end),
                      ("reset", "clk_0.clk_reset", end.replace("clk", "reset"))]
        modules.append(("slow", "clock_source", {}))
        self.system(modules, wires, [("leds", "leds.external_connection"),
                                     ("slow", "slow.clk_in"), ("slow_reset", "slow.clk_in_reset")],
                    ", .leds_export(LEDR), .slow_clk(slow), .slow_reset_reset_n(1'b1)")
        top = (self.folder / "top.v").read_text()
        (self.folder / "top.v").write_text(top.replace(
            "sys system", "reg slow = 0; always @(posedge CLOCK_50) slow <= !slow;\nsys system"))
        self.program("volatile uint32_t* const M = (volatile uint32_t*)0xFF201000;\n"
                     "uint32_t bad = 0; for (int i = 0; i < 64; i++) M[i] = i * 0x12345678u;\n"
                     "for (int i = 63; i >= 0; i--) if (M[i] != i * 0x12345678u) bad = 1;\n"
                     "R8(0xFF201006) = 0x7F; if (R32(0xFF201004) != 0x127F5678) bad |= 2;\n"
                     "R32(0xFF201100) = bad | 0x200; if (R32(0xFF201100) != (bad | 0x200))\n"
                     "R32(0xFF201100) = 4;")
        self.shows(0x200)
        self.assertIn("  0xFF201100 - 0xFF20110F  leds.s1\n",
                      self.de1sim("check", "top.qsf").stdout)

    def test_a_bridge(self):
        for command, response in ("1", "1"), ("0", "0"), ("1", "0"):
            self.bridged("altera_avalon_mm_bridge",
                         {"PIPELINE_COMMAND": command, "PIPELINE_RESPONSE": response},
                         {"bridge.clk": "clk_0.clk", "leds.clk": "clk_0.clk",
                          "memory.clk1": "clk_0.clk"})

    def test_a_bridge_from_one_clock_to_another(self):
        self.bridged("altera_avalon_mm_clock_crossing_bridge", {},
                     {"bridge.s0_clk": "clk_0.clk", "bridge.m0_clk": "slow.clk",
                      "leds.clk": "slow.clk", "memory.clk1": "slow.clk"})

    def test_a_memorys_file_that_platform_designer_would_make(self):
        memory = {"memorySize": "64", "dataWidth": "32", "autoInitializationFileName": "sys_ram"}
        self.with_leds([("ram", "altera_avalon_onchip_memory2", memory)],
                       [*clocked("ram", "clk1", "reset1"),
                        ("avalon", LW, "ram.s1", 0x40)])
        self.program("R32(0xFF200000) = R32(0xFF200044) + 1;")
        self.assertNotIn("sys_ram.hex", self.shows(1).stderr)
        self.write(sys_ram_hex=":0400010000000007F4\n:00000001FF\n")
        self.shows(8)

    def test_a_memorys_broken_file(self):
        memory = {"memorySize": "64", "dataWidth": "32", "useNonDefaultInitFile": "true",
                  "initializationFileName": "words.hex"}
        self.with_leds([("ram", "altera_avalon_onchip_memory2", memory)],
                       [*clocked("ram", "clk1", "reset1"),
                        ("avalon", LW, "ram.s1", 0x40)])
        self.write(words_hex="00000001\n0000beef\n")
        for command in "check", "build":
            self.refused('words.hex:1: "00000001" are words for $readmemh, expected Intel HEX',
                         command, ".")

    def test_a_rom_that_a_debugger_may_write(self):
        """Its port for that is there only where it is no RAM; a program does not write it."""
        rom = {"memorySize": "64", "dataWidth": "32", "writable": "false", "dualPort": "true",
               "singleClockOperation": "true", "autoInitializationFileName": "sys_rom"}
        self.write(sys_rom_hex=":0400010000000007F4\n:00000001FF\n")
        self.with_leds([("rom", "altera_avalon_onchip_memory2", rom)],
                       [*clocked("rom", "clk1", "reset1"),
                        ("avalon", LW, "rom.s1", 0x40)], [("rom", "rom.s2")],
                       ", .rom_address(4'd2), .rom_debugaccess(SW[0]), .rom_write(1'b1),"
                       ".rom_chipselect(1'b1), .rom_clken(1'b1), .rom_writedata(32'd5),"
                       ".rom_byteenable(4'd15), .rom_readdata()")
        self.program("for (;;) { R32(0xFF200044) = 1;\n"
                     "R32(0xFF200000) = R32(0xFF200044) << 4 | R32(0xFF200048); }")
        self.shows(0x70)
        self.shows(0x75, steps=["hold: {switch: 0}"])

    def test_an_export_of_the_name_of_an_instances_port(self):
        """Of sink's clock, and of the PIO's own export."""
        self.write(sink_v="module sink(input clk, output red, output green);\n"
                          "assign red = clk, green = 1; endmodule\n")
        (self.folder / "sink_hw.tcl").write_text(
            'add_fileset s QUARTUS_SYNTH "" ""\nset_module_property NAME sink\n'
            "set_fileset_property s TOP_LEVEL sink\nadd_fileset_file s.v VERILOG PATH sink.v\n"
            "add_interface clock clock end\nadd_interface_port clock clk clk Input 1\n"
            "add_interface vga conduit end\nadd_interface_port vga red clk Output 1\n"
            "add_interface_port vga green green Output 1\n")
        self.with_leds([("sink", "sink", {})], [("clock", "clk_0.clk", "sink.clock")],
                       [("sink", "sink.vga")], ", .sink_clk(), .sink_green()")
        self.program("R32(0xFF200000) = 5;")
        self.shows(5)

    def test_strays_are_reported_with_who_gets_them(self):
        memory = [("memory", "altera_avalon_onchip_memory2",
                   {"memorySize": "256", "initMemContent": "false"})]
        self.with_leds(memory, [*clocked("memory", "clk1", "reset1"),
                                ("avalon", LW, "memory.s1", 0x100)])
        self.program("R32(0xFF200040) = 9; R32(0xFF200200) = 6;")
        done = self.shows(6)
        self.assertIn("write to 0xFF200040: nobody is there; the interconnect sends it to "
                      "memory.s1", done.stderr)
        self.assertIn("write to 0xFF200200: the interconnect sees leds there, as at 0xFF200000: "
                      "addresses repeat each 0x200 bytes", done.stderr)

    def test_a_slave_that_never_answers_is_named(self):
        (self.folder / "stuck_hw.tcl").write_text(STORE_TCL.format(
            name="stuck", width=32, properties="",
            ports="add_interface_port s waitrequest waitrequest Output 1"))
        (self.folder / "stuck.v").write_text(
            "module stuck(input clk, input reset, input [3:0] address, input write, input read, "
            "input [31:0] writedata, output [31:0] readdata, output waitrequest);\n"
            "assign waitrequest = 1'b1;\nassign readdata = 0;\nendmodule\n")
        for bridge, window in (LW, 0xFF200000), (FULL, 0xC0000000):
            self.with_leds([("stuck_0", "stuck", {})],
                           [*clocked("stuck_0", "clock"),
                            ("avalon", bridge, "stuck_0.s", 0x40)])
            self.program(f"R32(0xFF200000) = R32({window + 0x44:#x});")
            done = self.de1sim("run", "--elf", "program.elf", "--project", "top.qsf",
                               "--duration", "30ms")
            self.assertEqual(done.returncode, 1, done.stderr)
            self.assertIn(f"read of 4 bytes at 0x{window + 0x44:08X} (stuck_0 did not answer",
                          done.stderr)

    def test_the_addresses_are_listed(self):
        self.with_leds()
        self.program("")
        done = self.de1sim("check", "top.qsf")
        self.assertIn("addresses of hps_0.h2f_lw_axi_master:\n"
                      "  0xFF200000 - 0xFF20000F  leds.s1\n", done.stdout)

    def test_a_system_beside_the_projects_folder(self):
        self.with_leds()
        self.write(quartus__top_qsf="set_global_assignment -name DEVICE 5CSEMA5F31C6\n"
                                    "set_global_assignment -name VERILOG_FILE ../top.v\n"
                                    "set_global_assignment -name QIP_FILE "
                                    "../sys/synthesis/sys.qip\n")
        done = self.de1sim("check", "quartus/top.qsf")
        self.assertIn("0xFF200000 - 0xFF20000F  leds.s1\n", done.stdout, done.stderr)

    def test_a_script_that_makes_the_project(self):
        self.with_leds()
        (self.folder / "top.qsf").unlink()
        self.write(make_tcl='set name top\nproject_new $name -overwrite\nforeach {n v} {DEVICE '
                            '5CSEMA5F31C6 TOP_LEVEL_ENTITY top VERILOG_FILE top.v\nQIP_FILE '
                            'sys/synthesis/sys.qip} {set_global_assignment -name $n $v}\n'
                            'project_close\n')
        self.program("R32(0xFF200000) = 3;")
        self.write(s_yaml='name: s\nversion: 1\nprogram: program.elf\nproject: make.tcl\nsteps:\n'
                          '  - expect-leds: {equals: "0000000011", timeout: 100ms}\n')
        done = self.de1sim("run", "s.yaml")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_a_system_without_a_processor_by_the_verilog_that_was_made_of_it(self):
        self.write(top_v=TOP.format(", .out_export(LEDR)", ""), sys_qsys=qsys(BASE[:1], []),
                   sys__synthesis__sys_qip="set_global_assignment -name VERILOG_FILE [file join "
                                           "$::quartus(qip_path) sys.v]\n",
                   sys__synthesis__sys_v="module sys(input clk_clk, input reset_reset_n, output "
                                         "[9:0] out_export); assign out_export = 9; endmodule\n",
                   top_qsf="set_global_assignment -name VERILOG_FILE top.v\n"
                           "set_global_assignment -name QSYS_FILE sys.qsys\n"
                           "set_global_assignment -name QIP_FILE sys/synthesis/sys.qip\n")
        self.leds(9, project="top.qsf")

    def test_a_processor_in_a_subsystem(self):
        """The Verilog that was made of it, with the vendor's primitives, is not taken."""
        leds, wires = pio("leds", 0)
        wires = [[word.replace(LW, "soc.h2f_lw") if isinstance(word, str) else word
                  for word in wire] for wire in wires]
        self.write(soc_system_qsys=qsys(BASE, CLOCKS,
                                        [("h2f_lw", "hps_0.h2f_lw_axi_master")]),
                   sys_qsys=qsys([BASE[0], ("soc", "soc_system", {}), *leds],
                                 [*clocked("soc"), *wires],
                                 [("leds", "leds.external_connection")]),
                   sys__synthesis__sys_v="// Generated using ACDS version 18.1\n"
                                         "module sys(output [9:0] leds_export);\nendmodule\n",
                   top_v=TOP.format(", .leds_export(LEDR)", ""),
                   top_qsf="set_global_assignment -name VERILOG_FILE top.v\n"
                           "set_global_assignment -name VERILOG_FILE sys/synthesis/sys.v\n"
                           "set_global_assignment -name QSYS_FILE sys.qsys\n")
        self.program("R32(0xFF200000) = 0x155;")
        self.shows(0x155)


run()
