"""workarounds.py [NAME [PROBE]]: whether the fault NAME of a tool is still there.

Passes where the fault is as FAULTS below has it for this release of Debian.  Where no release has
it any more, or the table is wrong, one line says what to remove or to change.  PROBE is
libraries.cpp, by an absolute path.  Without arguments it prints the names.
"""
import os
import pathlib
import platform
import re
import subprocess
import sys
import tempfile

RELEASES = ["12", "13"]  # of Debian, that de1sim supports
WARNINGS = ["-Wno-fatal", "-Wno-lint", "-Wno-style", "-Wno-BLKANDNBLK"]

MAIN = """
#include "Vtop.h"
#include <cstdio>
int main() { Vtop top; %s printf("%%d\\n", int(top.o)); }
"""
VHDL = """
library ieee; use ieee.std_logic_1164.all; use ieee.numeric_std.all;
entity top is port (s : in std_logic_vector(1 downto 0); a, b : in signed(3 downto 0);
                    o : out %s); end;
architecture x of top is %s begin %s end;
"""


def run(*words, may_fail=False):
    done = subprocess.run(words, capture_output=True, text=True, errors="replace", check=False)
    if done.returncode and not may_fail:
        sys.exit(f"{' '.join(map(str, words))}: {done.stdout}{done.stderr}")
    return done.stdout + done.stderr


def verilog(text, drive="top.eval();"):
    """What output `o` of module top is, as a number, after `drive`."""
    pathlib.Path("top.v").write_text(text)
    pathlib.Path("main.cpp").write_text(MAIN % drive)
    said = run("verilator", "--cc", "--exe", "--build", "-CFLAGS", "-O0", *WARNINGS, "top.v",
               "main.cpp", may_fail=True)
    return int(run("obj_dir/Vtop")) if "%Error" not in said else None


def synthesised(kind, body, declared=""):
    """What GHDL makes of a design whose output `o` is of type `kind`."""
    pathlib.Path("top.vhd").write_text(VHDL % (kind, declared, body))
    run("ghdl", "-a", "--std=08", "top.vhd")
    return run("ghdl", "--synth", "--std=08", "--out=verilog", "top")


# ---- One function for each fault: true, if it is there ----

def parameter_types():
    return verilog("module m #(parameter signed [8:0] A = 1, B = 2) (output o);\n"
                   "assign o = B < 0; endmodule\n"
                   "module top(output o); m #(.B(9'h1ff)) u(o); endmodule\n") == 0


def part_drivers():
    return verilog("module top(inout [1:0] p, input x, output o);\n"
                   "assign p[0] = x; assign o = p[1]; endmodule\n", "top.p = 3; top.eval();") == 0


def both_assignments():
    return verilog("module top(input clk, output [9:0] o); reg [9:0] r = 0; assign o = r;\n"
                   "always @(posedge clk) begin r[3:0] = 4'd5; r[9:8] <= 2;\n"
                   "  if (r[0]) r[5] <= 1; r[4] = r[4] + 1; end endmodule\n",
                   "top.eval(); top.clk = 1; top.eval();") & 15 != 5


def names_with_blanks():
    pathlib.Path("a b.v").write_text("module top(output o); assign o = unknown; endmodule\n")
    return "a b.v:1" not in run("verilator", "--lint-only", "a b.v", may_fail=True)


def pulls_of_ports():
    levels = "".join(f"module {name}(a, o); input a; output o; tri1 a; {body} endmodule\n"
                     for name, body in (("inner", "assign o = a;"), ("outer", "inner u(a, o);")))
    return verilog(levels + "module top(input r, output o); outer u(r, o); endmodule\n",
                   "top.r = 0; top.eval();") == 1


def defaults_of_ports():
    return verilog("module m(input a = 1'b1, output o); assign o = a; endmodule\n"
                   "module top(output o); m u(.o(o)); endmodule\n") != 1


def choice_of_others():
    return "default:" not in synthesised(
        "std_logic", "process (all) begin case s is when \"01\" => o <= '1';\n"
                     "when \"10\" => o <= '0'; when others => o <= a(0); end case; end process;")


def wide_constants():
    return '"0001' in synthesised("std_logic_vector(35 downto 0)",
                                  "o <= x\"123456789\" when s(0) = '1' else x\"0F0F0F0F0\";")


def signed_remainders():
    return "$signed" not in synthesised("signed(3 downto 0)", "o <= a rem b;")


def signed_quotients():
    return "$signed" not in synthesised("signed(3 downto 0)", "o <= a / b;")


def signed_shifts():
    return ">>>" not in synthesised("signed(3 downto 0)", "o <= shift_right(a, 1);")


def absolute_values():
    return "std_logic_vector" in synthesised("signed(3 downto 0)", "o <= abs a;")


def keywords():
    return "\\reg" not in synthesised("std_logic", "reg <= a(0) and b(0); o <= reg;",
                                    "signal reg : std_logic;")


def times_of_units():
    pathlib.Path("inner.vhd").write_text("entity inner is port (o : out integer); end;\n"
                                         "architecture x of inner is begin o <= 3; end;\n")
    pathlib.Path("outer.vhd").write_text(
        "entity outer is port (o : out integer); end;\n"
        "architecture x of outer is begin u : entity work.inner port map (o); end;\n")
    run("ghdl", "-i", "--std=08", "outer.vhd", "inner.vhd")
    library = pathlib.Path("work-obj08.cf")
    library.write_text(re.sub(r'(file .*"inner.*)\.\d+"', r'\1.200"',
                              re.sub(r'(file .*"outer.*)\.\d+"', r'\1.100"', library.read_text())))
    return "obsoleted" in run("ghdl", "--synth", "--std=08", "outer", may_fail=True)


def blanks_for_yosys():
    pathlib.Path("a b").mkdir()
    return "ERROR" in run("yosys", "-p", 'tee -o "a b/log" stat', may_fail=True)


def run_up_of_webm():
    run("ffmpeg", "-v", "error", "-f", "lavfi", "-i", "sine=d=0.1", "-ar", "48000", "-c:a",
        "libopus", "-avoid_negative_ts", "disabled", "film.webm")
    first = run("ffprobe", "-v", "error", "-show_entries", "packet=pts_time", "-of", "csv=p=0",
                "film.webm").split()[0]
    return float(first) < -0.01  # the encoder's run-up is 6.5 ms: twice


def of_a_library(name):
    return lambda: run(sys.argv[2], name).split()[0] == "there"  # then SystemC's banner


# Name: the function, the tool, the releases of Debian that have the fault, what is there for it.
FAULTS = {
    "parameter_types": (parameter_types, "Verilator", "12", "sim/verilog/parameter_types.cpp"),
    "part_drivers": (part_drivers, "Verilator", "12 13", "sim/verilog/part_drivers.cpp"),
    "both_assignments": (both_assignments, "Verilator", "12 13",
                         "in sim/verilog/registers.cpp the copy of what is also set by <="),
    "names_with_blanks": (names_with_blanks, "Verilator", "12",
                          "without_blanks() and with_blanks() in sim/verilog/run_tool.cpp, and the "
                          "relative paths in rtl/sources.cmake and tb/netlist/CMakeLists.txt"),
    "pulls_of_ports": (pulls_of_ports, "Verilator", "12 13", "what tb/lint/ip.py says of pulls"),
    "defaults_of_ports": (defaults_of_ports, "Verilator", "12", "rtl/ip/defaults.tsv"),
    "choice_of_others": (choice_of_others, "GHDL", "12",
                         "with_others() in sim/vhdl/vhdl_repairs.cpp"),
    "wide_constants": (wide_constants, "GHDL", "12",
                       "with_wide_constants() in sim/vhdl/vhdl_repairs.cpp"),
    "signed_remainders": (signed_remainders, "GHDL", "12 13",
                          "srem and smod in sim/vhdl/vhdl_repairs.cpp"),
    "signed_quotients": (signed_quotients, "GHDL", "12",
                         "sdiv in sim/vhdl/vhdl_repairs.cpp"),
    "signed_shifts": (signed_shifts, "GHDL", "12",
                      "the shift of operation() in sim/vhdl/vhdl_repairs.cpp"),
    "absolute_values": (absolute_values, "GHDL", "12",
                        "abs and `when` of operation() in sim/vhdl/vhdl_repairs.cpp"),
    "keywords": (keywords, "GHDL", "12",
                 "with_escaped_names() in sim/vhdl/vhdl_repairs.cpp"),
    "times_of_units": (times_of_units, "GHDL", "12", "have_one_time() in sim/vhdl/vhdl.cpp"),
    "blanks_for_yosys": (blanks_for_yosys, "Yosys", "12 13",
                         "the relative paths in tb/formal/prove.py and tb/synth/CMakeLists.txt"),
    "run_up_of_webm": (run_up_of_webm, "FFmpeg", "12",
                       "asetpts of command_for() in sim/video/video.cpp"),
    "seconds": (of_a_library("seconds"), "SystemC", "12 13", "sim/text/seconds.h"),
}


def verdict(there, tool, having, what):
    """A line if the table is wrong, or the fault is nowhere any more; else nothing."""
    system = platform.freedesktop_os_release()
    release = system.get("VERSION_ID", "") if system["ID"] == "debian" else ""
    supported = [one for one in having if one in RELEASES]
    if not supported:
        return f"no longer needed with {tool} of Debian {' and '.join(RELEASES)}: remove {what}"
    if release not in RELEASES:
        print(f"not a release of Debian that is known here: {tool} {'has' if there else 'lacks'} "
              "the fault")
        return None
    others = [one for one in supported if one != release]
    if release in supported and not there:
        return (f"no longer needed with {tool} of Debian {release}: remove {what}" if not others
                else f"no longer needed with {tool} of Debian {release}: say so in FAULTS")
    if release not in supported and there:
        return f"{tool} of Debian {release} has the fault, too: say so in FAULTS"
    print(f"{tool} of Debian {release} {'has' if there else 'lacks'} the fault; "
          f"needed for Debian {' and '.join(supported)}")
    return None


def main():
    if len(sys.argv) == 1:
        print(" ".join(FAULTS))
        return None
    is_there, tool, releases, what = FAULTS[sys.argv[1]]
    with tempfile.TemporaryDirectory() as folder:  # without a blank in its path, for Verilator
        os.chdir(folder)
        return verdict(is_there(), tool, releases.split(), what)


if __name__ == "__main__":
    sys.exit(main())
