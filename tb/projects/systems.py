"""systems.py - .qsys files of a few lines, with a program on them"""
import pathlib
import struct
import subprocess
import zlib

from case import Case

HPS = {"LWH2F_Enable": "true", "S2F_Width": "2", "F2S_Width": "0", "F2SINTERRUPT_Enable": "true"}
LW, FULL = "hps_0.h2f_lw_axi_master", "hps_0.h2f_axi_master"
EXAMPLES = pathlib.Path(__file__).resolve().parents[2] / "sw/examples"
GCC = ["arm-none-eabi-gcc", "-mcpu=cortex-a9", "-mgeneral-regs-only", "-mno-unaligned-access",
       "-O1", "-ffreestanding", "-nostartfiles", f"-I{EXAMPLES}", f"-T{EXAMPLES / 'program.ld'}",
       str(EXAMPLES / "start.S")]
BASE = [("clk_0", "clock_source", {}), ("hps_0", "altera_hps", HPS)]
# Of a component NAME in NAME.v, whose interfaces follow.
HW_TCL = """package require -exact qsys 16.1
set_module_property NAME {name}
add_fileset QUARTUS_SYNTH QUARTUS_SYNTH "" ""
set_fileset_property QUARTUS_SYNTH TOP_LEVEL {name}
add_fileset_file {name}.v VERILOG PATH {name}.v TOP_LEVEL_FILE
add_interface clock clock end
add_interface_port clock clk clk Input 1
add_interface reset reset end
set_interface_property reset associatedClock clock
add_interface_port reset reset reset Input 1
"""
OWN_CLOCK = """set_interface_property s associatedClock clock
set_interface_property s associatedReset reset
"""
CLOCKS = [("clock", "clk_0.clk", "hps_0.h2f_axi_clock"),
          ("clock", "clk_0.clk", "hps_0.h2f_lw_axi_clock")]
TOP = """module top(input CLOCK_50, input [9:0] SW, output [9:0] LEDR{1});
sys system(.clk_clk(CLOCK_50), .reset_reset_n(1'b1){0});
endmodule
"""


def qsys(modules, connections, exports=(), clock="clk_0"):
    """With the exports of its clock, if that has a name."""
    text = '<?xml version="1.0"?>\n<system name="$${FILENAME}">\n'
    if clock:
        exports = [("clk", clock + ".clk_in"), ("reset", clock + ".clk_in_reset"), *exports]
    for name, internal in exports:
        text += f' <interface name="{name}" internal="{internal}" type="conduit" dir="end" />\n'
    for name, kind, parameters in modules:
        text += f' <module name="{name}" kind="{kind}" version="18.1" enabled="1">\n'
        for parameter, value in parameters.items():
            text += f'  <parameter name="{parameter}" value="{value}" />\n'
        text += " </module>\n"
    for kind, start, end, *number in connections:
        text += f' <connection kind="{kind}" version="18.1" start="{start}" end="{end}">\n'
        name = {"avalon": "baseAddress", "interrupt": "irqNumber"}.get(kind)
        if number:
            text += f'  <parameter name="{name}" value="{number[0]:#x}" />\n'
        text += " </connection>\n"
    return text + "</system>\n"


def clocked(name, clock="clk", reset="reset"):
    """The wires of a module's clock and reset."""
    return [("clock", "clk_0.clk", f"{name}.{clock}"),
            ("reset", "clk_0.clk_reset", f"{name}.{reset}")]


def pio(name, base, **parameters):
    """An output port of ten bits on the lightweight bridge."""
    return ([(name, "altera_avalon_pio", {"width": "10", "direction": "Output", **parameters})],
            [*clocked(name), ("avalon", LW, f"{name}.s1", base)])


def png(path, rows):
    """Rows of (red, green, blue)."""
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I",
                                                                        zlib.crc32(kind + data))

    data = b"".join(b"\0" + bytes(value for pixel in row for value in pixel) for row in rows)
    path.write_bytes(b"\x89PNG\r\n\x1a\n" +
                     chunk(b"IHDR", struct.pack(">IIBBBBB", len(rows[0]), len(rows), 8, 2, 0, 0, 0))
                     + chunk(b"IDAT", zlib.compress(data)) + chunk(b"IEND", b""))



class SystemCase(Case):
    def system(self, modules=(), connections=(), exports=(), top="", ports="", **files):
        self.write(sys_qsys=qsys([*BASE, *modules], [*CLOCKS, *connections], exports),
                   top_v=TOP.format(top, ports),
                   top_qsf="set_global_assignment -name DEVICE 5CSEMA5F31C6\n"
                           "set_global_assignment -name VERILOG_FILE top.v\n"
                           "set_global_assignment -name QSYS_FILE sys.qsys\n", **files)

    def program(self, body, head=""):
        self.write(program_c="#include <stdint.h>\n"
                             "#define R8(a) (*(volatile uint8_t*)(a))\n"
                             "#define R16(a) (*(volatile uint16_t*)(a))\n"
                             "#define R32(a) (*(volatile uint32_t*)(a))\n"
                             "#define R64(a) (*(volatile uint64_t*)(a))\n"
                             f"{head}int main(void) {{\n{body}\nfor (;;) {{}}\n}}\n")
        subprocess.run([*GCC, "program.c", "-o", "program.elf"], cwd=self.folder, check=True)

    def played(self, *steps, head="", code=0, options=()):
        """The program in the system, with lines of the scenario before its steps."""
        self.write(s_yaml="name: s\nversion: 1\nprogram: program.elf\nproject: top.qsf\n" + head +
                          "steps:\n" + "".join(f"  - {step}\n" for step in steps))
        done = self.de1sim("run", "s.yaml", *options)
        self.assertEqual(done.returncode, code, done.stdout + done.stderr)
        return done

    def shows(self, leds, steps=()):
        """After the steps."""
        return self.played(*steps, f'expect-leds: {{equals: "{leds:010b}", timeout: 100ms}}')

    def with_leds(self, modules=(), connections=(), exports=(), top="", **files):
        leds, wires = pio("leds", 0)
        self.system([*leds, *modules], [*wires, *connections],
                    [("leds", "leds.external_connection"), *exports],
                    ", .leds_export(LEDR)" + top, **files)

    def refuses(self, message, modules=(), connections=(), **files):
        self.with_leds(modules, connections, **files)
        self.refused(message, "check", "top.qsf")
