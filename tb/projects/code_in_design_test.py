"""code_in_design_test.py DE1SIM FOLDER [CASE...] - programs linked to the design's own memory"""
import subprocess

from case import run
from systems import EXAMPLES, FULL, GCC, LW, SystemCase, clocked

LEDS = "#define LEDS R32(0xFF200000)\n"


class CodeInDesign(SystemCase):
    def memory(self, bridge=FULL, base=0, **parameters):
        """32 KB of on-chip memory, and the lamps."""
        self.with_leds([("ram", "altera_avalon_onchip_memory2",
                         {"memorySize": "32768", **parameters})],
                       [*clocked("ram", "clk1", "reset1"), ("avalon", bridge, "ram.s1", base)])

    def linked(self, address, body, head=""):
        """All of the program at this address."""
        self.program(body, LEDS + head)
        script = (EXAMPLES / "program.ld").read_text().replace(". = 0;", f". = {address:#x};")
        self.write(own_ld=script)
        words = [word for word in GCC if not word.startswith("-T")]
        subprocess.run([*words, "-Town.ld", "program.c", "-o", "program.elf"], cwd=self.folder,
                       check=True)

    SUM = ("static uint32_t calls = 5, zero;\n"
           "__attribute__((noinline)) uint32_t sum(uint32_t n) {\n"
           "    calls++; return n == 0 ? zero : n + sum(n - 1);\n}\n")

    def test_by_either_bridge(self):
        for bridge, base, address in (FULL, 0x10000, 0xC0010000), (LW, 0x10000, 0xFF210000):
            self.memory(bridge, base)
            self.linked(address, "LEDS = sum(20) + calls;", self.SUM)
            self.shows(210 + 5 + 21)

    def test_code_that_the_program_writes_is_executed(self):
        """A MOV r0, #n and a BX lr, twice at the same place; the second over the first."""
        self.memory()
        self.linked(0xC0000000, "uint32_t first, second;\n"
                    "code[0] = 0xE3A00011; code[1] = 0xE12FFF1E;\n"
                    "first = ((uint32_t (*)(void))code)();\n"
                    "code[0] = 0xE3A00022;\nsecond = ((uint32_t (*)(void))code)();\n"
                    "LEDS = first << 4 | second;", "volatile uint32_t code[2];\n")
        self.shows(0x132)

    def test_a_part_of_the_program_in_the_design(self):
        self.memory()
        self.program('LEDS = far(3);', LEDS + "__attribute__((noinline, section(\".far\")))\n"
                     "uint32_t far(uint32_t n) { return n * 77; }\n")
        script = (EXAMPLES / "program.ld").read_text()
        self.write(own_ld=script[:script.rindex("}")] + "    .far 0xC0000400 : { *(.far) }\n}\n")
        words = [word for word in GCC if not word.startswith("-T")]
        subprocess.run([*words, "-mlong-calls", "-Town.ld", "program.c", "-o", "program.elf"],
                       cwd=self.folder, check=True)
        self.shows(231)

    def test_where_nothing_is(self):
        self.memory()
        self.linked(0xC0100000, "LEDS = 1;")
        done = self.played("delay: 1ms", code=2)
        self.assertIn("is linked to the FPGA, where the design has no memory of that size: "
                      "expected addresses of its memory", done.stderr)

    def test_a_memory_that_cannot_be_written(self):
        self.memory(writable="false")
        self.linked(0xC0000000, "LEDS = 1;")
        done = self.played("delay: 20ms", code=1)
        self.assertRegex(done.stderr + done.stdout, "the program cannot be loaded into the design: "
                         "at 0xC0000000 0x[0-9A-F]{8} was written, and 0x[0-9A-F]{8} is read; "
                         "expected a memory that can be written")


run()
