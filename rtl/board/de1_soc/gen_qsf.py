"""gen_qsf.py - prints de1_soc.qsf: every port of de1_soc_top.v at its pin, and the project's files.

    gen_qsf.py [RTL]      RTL is the folder rtl/, the one that this lies in by default

Exit 1, with a line for each, when a port has no pin in board.tsv, or a port or pin is there twice.
"""
import pathlib
import re
import sys

HEAD = """\
# de1_soc.qsf - the Quartus project; machine-made: make qsf
set_global_assignment -name FAMILY "Cyclone V"
set_global_assignment -name DEVICE 5CSEMA5F31C6
set_global_assignment -name TOP_LEVEL_ENTITY de1_soc_top
set_global_assignment -name PROJECT_OUTPUT_DIRECTORY ../../../build/bitstream
set_global_assignment -name VERILOG_INPUT_VERSION VERILOG_2001
set_global_assignment -name RESERVE_ALL_UNUSED_PINS_WEAK_PULLUP \
"AS INPUT TRI-STATED WITH WEAK PULL-UP"
set_global_assignment -name STRATIX_DEVICE_IO_STANDARD "3.3-V LVTTL"
set_global_assignment -name NUM_PARALLEL_PROCESSORS ALL
set_global_assignment -name TIMING_ANALYZER_MULTICORNER_ANALYSIS ON
set_global_assignment -name SDC_FILE de1_soc.sdc
"""


def ports(verilog):
    """Names of the top module's ports, a bus bit by bit."""
    found = []
    head = re.sub(r"//[^\n]*", "", verilog).split(");", 1)[0]
    for high, name in re.findall(r"(?:input|output|inout)\s+wire\s+(?:\[(\d+):0\]\s+)?(\w+)", head):
        found += [f"{name}[{bit}]" for bit in range(int(high) + 1)] if high else [name]
    return found


def pins(table):
    """Signals bit by bit, and their pins; not the lines that say something of the board."""
    rows = [line.split("\t") for line in table.splitlines() if not line.startswith("#")]
    found = []
    for signal, _, where, *_ in (row for row in rows if len(row) > 2):
        at = [f"PIN_{pin}" for pin in where.split()]
        found += [(f"{signal}[{bit}]" if len(at) > 1 else signal, pin)
                  for bit, pin in enumerate(at)]
    return found


def sources(rtl):
    text = (rtl / "sources.cmake").read_text()

    def words(name):
        return re.search(r"set\(" + name + r"\s+(.*?)\)", text, re.S)[1].split()
    return words("RTL_SOURCES") + words("BOARD_SOURCES"), words("RTL_INCLUDES")


def problems(wanted, table):
    known, at = [signal for signal, _ in table], [pin for _, pin in table]
    yield from (f"{port}: no pin in board.tsv" for port in wanted if port not in known)
    yield from (f"{port}: twice in the top" for port in set(wanted) if wanted.count(port) > 1)
    yield from (f"{signal}: twice in board.tsv" for signal in set(known) if known.count(signal) > 1)
    yield from (f"{pin}: two signals in board.tsv" for pin in set(at) if at.count(pin) > 1)


def main():
    here = pathlib.Path(__file__).parent
    rtl = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else here.parent.parent
    board = rtl / "board" / "de1_soc"
    wanted = ports((board / "de1_soc_top.v").read_text())
    table = pins((board / "board.tsv").read_text())
    wrong = list(problems(wanted, table))
    if wrong:
        print("\n".join(wrong), file=sys.stderr)
        return 1
    files, includes = sources(rtl)
    print(HEAD, end="")
    for folder in includes:
        print(f"set_global_assignment -name SEARCH_PATH ../../{folder}")
    for file in files:
        print(f"set_global_assignment -name VERILOG_FILE ../../{file}")
    pin_of = dict(table)
    for port in wanted:
        print(f"set_location_assignment {pin_of[port]} -to {port}")
        print(f"set_instance_assignment -name IO_STANDARD \"3.3-V LVTTL\" -to {port}")
    return 0


sys.exit(main())
