"""prove.py - proves one harness with Yosys and z3.

prove.py --rtl DIR --work DIR --depth N [--induction] [--clocks] [--twins TWIN...]
    --harness HARNESS --sources SOURCE...

0 if every assert holds for N clocks from any state that a reset clock leads out of, and with
--induction for ever (N-step induction).

With --clocks the clocks are inputs like others, and N counts steps in which each may tick or not.

A harness sees into its instances by wires that it leaves undriven: dut__part__name is
dut.part.name, dut__name__3 is word 3 of a memory.  They carry invariants that induction needs.
Where no word of a memory is named, memories are the solver's arrays.

A TWIN is a file of sim/fpga, which takes the place of one of rtl/ in the simulation.  Its module
has _twin after its name here, so that both can be in one harness.  What stands in a harness after
`ifdef TWIN is there if a TWIN is given; what stands after `else, if not.
"""
import argparse
import os
import pathlib
import re
import subprocess
import sys


def run(command, log):
    done = subprocess.run(command, cwd=log.parent, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, text=True)
    log.write_text(done.stdout)
    return done


def renamed(twin, work):
    """A copy of the twin whose module has _twin after its name."""
    copy = work / f"{twin.stem}_twin.v"
    copy.write_text(re.sub(rf"^module {twin.stem}\b", rf"module {twin.stem}_twin",
                           twin.read_text(), flags=re.M))
    return copy


def write_smt2(arguments, sources):
    top = arguments.harness.stem
    kept = r"\1" if arguments.twins else r"\2"
    text = re.sub(r"^`ifdef TWIN\n(.*?)(?:^`else\n(.*?))?^`endif\n", kept,
                  arguments.harness.read_text(), flags=re.M | re.S)
    harness = arguments.work / arguments.harness.name
    harness.write_text(text)
    # From the folder of the outputs, since Yosys splits paths at blanks.
    rtl = os.path.relpath(arguments.rtl, arguments.work)
    includes = " ".join(f"-I{rtl}/{folder}" for folder in ("regmap", "bus", "vga"))
    files = " ".join(os.path.relpath(source, arguments.work) for source in [*sources, harness])
    names = sorted(set(re.findall(r"\b[a-z]+__\w+", text)))
    words = "memory_map" if any(re.search(r"__\d+$", name) for name in names) else ""
    script = [f"read_verilog -sv -formal {includes} {files}",
              f"hierarchy -check -top {top}; proc; memory_collect; {words}; flatten",
              f"cd {top}"]
    for name in names:
        inner = name.replace("__", ".")
        word = re.fullmatch(r"(.+)\.(\d+)", inner)
        if word:
            script.append(f"rename {word[1]}[{word[2]}] {inner}")
        script.append(f"connect -nounset -set {name} {inner}")
    smt2 = arguments.work / "problem.smt2"
    script.append(f"cd ..; prep -top {top} -nordff; opt -fast; check -assert; "
                  f"{'clk2fflogic' if arguments.clocks else 'async2sync'}; "
                  f"dffunmap; write_smt2 -wires {smt2.name}")
    if run(["yosys", "-q", "-p", "; ".join(script)], arguments.work / "yosys.log").returncode:
        sys.exit((arguments.work / "yosys.log").read_text())
    return smt2


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--rtl", type=pathlib.Path, required=True)
    parser.add_argument("--work", type=pathlib.Path, required=True)
    parser.add_argument("--depth", type=int, required=True)
    parser.add_argument("--induction", action="store_true")
    parser.add_argument("--clocks", action="store_true")
    parser.add_argument("--twins", type=pathlib.Path, nargs="*", default=[])
    parser.add_argument("--harness", type=pathlib.Path, required=True)
    parser.add_argument("--sources", type=pathlib.Path, nargs="*", default=[])
    arguments = parser.parse_args()
    arguments.work.mkdir(parents=True, exist_ok=True)
    sources = [arguments.rtl / source for source in arguments.sources]
    sources += [renamed(twin, arguments.work) for twin in arguments.twins]
    smt2 = write_smt2(arguments, sources)
    steps = {"bounded": ["-t", str(arguments.depth)]}
    if arguments.induction:
        # Of N clocks at once: to try fewer first would take z3 up to eight times as long.
        steps["induction"] = ["-i", "-t", f"{arguments.depth}:{arguments.depth}"]
    for step, options in steps.items():
        done = run(["yosys-smtbmc", "-s", "z3", "--unroll", *options,
                    "--dump-vcd", str(arguments.work / f"{step}.vcd"), str(smt2)],
                   arguments.work / f"{step}.log")
        failed = sorted(set(re.findall(r"Assert failed in \w+: (\w+)", done.stdout)))
        if failed:
            sys.exit(f"{step}: {' '.join(failed)} failed, see {arguments.work}/{step}.vcd")
        if "Status: PASSED" not in done.stdout:
            sys.exit(done.stdout)


if __name__ == "__main__":
    main()
