"""prove.py - proves one harness with Yosys and z3, or shows that a mutant breaks a named property.

prove.py --rtl DIR --work DIR --depth N [--induction] [--clocks]
         [--mutant FILE.PROPERTY.sed --bound M] HARNESS SOURCE...

Without --mutant: 0 if every assert holds for N clocks from any state that a reset clock leads out
of, and with --induction for ever (N-step induction).  With --mutant: the sed script is applied to a
copy of the sources, and 0 means that the assert PROPERTY was seen to fail: within M clocks of a
reset, or else, with --induction, first of all, one clock after N clocks of any states in which
every assert held.

With --clocks the clocks are inputs like others, and N counts steps in which each may tick or not.

A harness sees into its instances by wires that it leaves undriven: dut__part__name is
dut.part.name, dut__name__3 is word 3 of a memory.  They carry invariants that induction needs.
Where no word of a memory is named, memories are the solver's arrays.
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


def mutated(arguments, sources):
    work = arguments.work
    copies = []
    for source in sources:
        copies.append(work / source.name)
        copies[-1].write_bytes(source.read_bytes())
    subprocess.run(["sed", "-i", "-f", arguments.mutant, *copies], check=True)
    if all(a.read_bytes() == b.read_bytes() for a, b in zip(sources, copies)):
        sys.exit(f"{arguments.mutant.name} changes nothing: the source has moved on")
    return copies


def write_smt2(arguments, step, sources):
    top = arguments.harness.stem
    text = arguments.harness.read_text()
    # From the folder of the outputs, since Yosys splits paths at blanks.
    rtl = os.path.relpath(arguments.rtl, arguments.work)
    includes = " ".join(f"-I{rtl}/{folder}" for folder in ("regmap", "bus", "vga"))
    files = " ".join(os.path.relpath(source, arguments.work) for source in sources)
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
    smt2 = arguments.work / f"{step}.smt2"
    if arguments.mutant:
        # $check is what an assertion is called by newer releases of Yosys.
        script.append("select -set others t:$assert t:$check %u "
                      f"c:{arguments.mutant.suffixes[0][1:]} %d; "
                      + ("chformal -assert2assume @others; chformal -delay 1 @others"
                         if step == "induction" else "delete @others"))
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
    parser.add_argument("--mutant", type=pathlib.Path)
    parser.add_argument("--bound", type=int)
    parser.add_argument("harness", type=pathlib.Path)
    parser.add_argument("sources", type=pathlib.Path, nargs="+")
    arguments = parser.parse_args()
    arguments.work.mkdir(parents=True, exist_ok=True)
    sources = [arguments.rtl / source for source in arguments.sources]
    if arguments.mutant:
        sources = mutated(arguments, sources)
    failed = set()
    steps = {"bounded": ["-t", str(arguments.bound or arguments.depth)]}
    if arguments.induction:
        # Of N clocks at once: to try fewer first would take z3 up to eight times as long.
        steps["induction"] = ["-i", "-t", f"{arguments.depth}:{arguments.depth}"]
    smt2 = None
    for step, options in steps.items():
        if arguments.mutant or not smt2:  # of the unchanged block both steps ask the same
            smt2 = write_smt2(arguments, step, [*sources, arguments.harness])
        # Of a mutant nobody looks at the waveform, which takes as long as a fifth of the proof.
        vcd = [] if arguments.mutant else ["--dump-vcd", str(arguments.work / f"{step}.vcd")]
        done = run(["yosys-smtbmc", "-s", "z3", "--unroll", *options, *vcd, str(smt2)],
                   arguments.work / f"{step}.log")
        failed |= set(re.findall(r"Assert failed in \w+: (\w+)", done.stdout))
        if "Status: PASSED" not in done.stdout and not failed:
            sys.exit(done.stdout)
        if failed and not arguments.mutant:
            sys.exit(f"{step}: {' '.join(sorted(failed))} failed, see {arguments.work}/{step}.vcd")
        if failed:
            break
    if arguments.mutant:
        wanted = arguments.mutant.suffixes[0][1:]
        if wanted not in failed:
            sys.exit(f"{wanted} holds in spite of the mutant; failed: {sorted(failed)}")


if __name__ == "__main__":
    main()
