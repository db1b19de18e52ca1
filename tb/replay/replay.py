"""replay.py - a second simulator's opinion: the stimuli of an RTL test, replayed in Icarus Verilog.

replay.py bind MODULE OUT.sv [--generic NAME=VALUE ...] SOURCE...
    writes the line that binds recorder.v to MODULE.
replay.py run MODULE TEST WORK [--generic ...] SOURCE...
    runs TEST, built with that line, in the folder WORK, and what it recorded through Icarus.
    0 if every output of every clock after a reset was the same.
"""
import argparse
import json
import pathlib
import re
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
RTL = HERE.parents[1] / "rtl"
INCLUDES = ["-Iregmap", "-Ibus", "-Ivga"]
ENOUGH_CLOCKS = 100


def ports(arguments):
    """(inputs but the clock, outputs), each a list of (name, width)."""
    generics = "".join(f"chparam -set {name} {value} {arguments.module}; "
                       for name, value in (g.split("=") for g in arguments.generic))
    script = (f"read_verilog {' '.join(INCLUDES + arguments.sources)}; {generics}"
              f"hierarchy -top {arguments.module}; proc; write_json /dev/stdout")
    done = subprocess.run(["yosys", "-q", "-p", script], cwd=RTL, stdout=subprocess.PIPE, text=True,
                          check=True)
    modules = json.loads(done.stdout)["modules"].values()
    module = next(m for m in modules if "top" in m["attributes"])
    found = {"input": [], "output": []}
    for name, port in module["ports"].items():
        if name != "clk_i":
            found[port["direction"]].append((name, len(port["bits"])))
    return found["input"], found["output"]


def width(some):
    return sum(bits for _, bits in some)


def names(some):
    return ", ".join(name for name, _ in some)


def bind(arguments):
    inputs, outputs = ports(arguments)
    arguments.out.write_text(
        f"// made by replay.py\nbind {arguments.module} recorder "
        f"#(.INPUTS({width(inputs)}), .OUTPUTS({width(outputs)})) recorder "
        f"(.clk_i(clk_i),\n    .inputs_i({{{names(inputs)}}}),\n"
        f"    .outputs_i({{{names(outputs)}}}));\n")


def connections(some, bus):
    left = width(some)
    for name, bits in some:
        yield f".{name}({bus}[{left - 1}:{left - bits}])"
        left -= bits


def run(arguments):
    inputs, outputs = ports(arguments)
    work = arguments.work.resolve()
    work.mkdir(parents=True, exist_ok=True)
    (work / "stimuli.txt").unlink(missing_ok=True)
    subprocess.run([arguments.test.resolve()], cwd=work, check=True, stdout=subprocess.DEVNULL)

    generics = ", ".join(f".{name}({value})" for name, value in
                         (g.split("=") for g in arguments.generic))
    (work / "dut.vh").write_text(
        f"localparam INPUTS = {width(inputs)}, OUTPUTS = {width(outputs)};\n"
        f"wire reset;\n"
        f"{arguments.module} #({generics}) dut (.clk_i(clk),\n    " +
        ",\n    ".join([*connections(inputs, "inputs"), *connections(outputs, "outputs")]) +
        ");\nassign reset = dut.rst_i;\n")
    program = work / "replay.vvp"
    subprocess.run(["iverilog", "-g2005", "-o", program, "-I", work, *INCLUDES, "-s", "replayer",
                    HERE / "replayer.v", *arguments.sources], cwd=RTL, check=True)
    text = subprocess.run(["vvp", "-n", program], cwd=work, stdout=subprocess.PIPE,
                          text=True, check=True).stdout
    print(text, end="")
    result = re.search(r"^(\d+) clocks compared, (\d+) differ$", text, re.MULTILINE)
    if not result or int(result[1]) < ENOUGH_CLOCKS:
        sys.exit(f"expected at least {ENOUGH_CLOCKS} clocks")
    sys.exit(int(result[2]) > 0)


def main():
    parser = argparse.ArgumentParser()
    commands = parser.add_subparsers(required=True)
    for name, act in {"bind": bind, "run": run}.items():
        command = commands.add_parser(name)
        command.set_defaults(act=act)
        command.add_argument("--generic", action="append", default=[])
        command.add_argument("module")
        if act is run:
            command.add_argument("test", type=pathlib.Path)
            command.add_argument("work", type=pathlib.Path)
        else:
            command.add_argument("out", type=pathlib.Path)
        command.add_argument("sources", nargs="+", help="under rtl/")
    arguments = parser.parse_args()
    arguments.act(arguments)


main()
