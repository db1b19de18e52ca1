"""table1.py run|check - the paper's experiments: measures, tables, plots, REPRODUCTION.md.

run    times everything, writes table1.csv, table1.md and the plots into --out, keeps the numbers as
       reproduction.csv beside --reproduction and writes that file's tables again
check  exit 1 if the tables in --reproduction are not those that reproduction.csv gives
"""
import argparse
import pathlib
import subprocess
import sys

import plots
import tables

COUNTS = "1,10,100,200"
SECONDS = "6"  # at most, a shape and count


def measure(program, *arguments):
    print("measuring", *arguments, flush=True)
    return subprocess.run([program, *arguments], check=True, stdout=subprocess.PIPE,
                          text=True).stdout


def measure_board(arguments):
    print("running collide.elf on the modelled A9", flush=True)
    out = arguments.out / "board"
    subprocess.run([arguments.de1sim, "run", arguments.scenario, "--cpu", "arm", "--elf",
                    arguments.elf, "--frames", "none", "--quiet", "--out", out], check=True)
    return tables.board_rows((out / "console.txt").read_text())


def run(arguments):
    rows = [measure(arguments.program, "optimised", "16", COUNTS, "all", SECONDS)]
    for size in "16", "8":
        rows.append(measure(arguments.program_O0, "-O0", size, COUNTS,
                            "original,original_all_lines,original_by_copy,improved", SECONDS))
    rows.append(measure_board(arguments))
    numbers = tables.HEADER + "".join(rows)
    growth = measure(arguments.program, "growth", "16", "10,30,100,300,1000,3000,10000",
                     "original,improved,improved_vector,sweep,simd", "3")

    arguments.out.mkdir(parents=True, exist_ok=True)
    (arguments.out / "table1.csv").write_text(numbers + growth)
    cells = tables.read(numbers)
    text = tables.table1(cells)
    (arguments.out / "table1.md").write_text(text)
    arguments.reproduction.with_name("reproduction.csv").write_text(numbers)
    arguments.reproduction.write_text(tables.rewritten(arguments.reproduction.read_text(), cells))
    print(text)
    print(tables.targets(cells))
    if arguments.gnuplot and pathlib.Path(arguments.gnuplot).exists():
        plots.draw(arguments.gnuplot, arguments.out, cells, tables.read(tables.HEADER + growth))
    else:
        print("no plots: gnuplot is not installed")
    unsettled = [row for row in cells.values() if row["settled"] != "yes"]
    if unsettled:
        print(f"{len(unsettled)} of {len(cells)} medians are not known within 3 %: "
              "the machine is too noisy")
    print(f"written: {arguments.out}/ and {arguments.reproduction}")
    return 0


def check(arguments):
    numbers = arguments.reproduction.with_name("reproduction.csv").read_text()
    text = arguments.reproduction.read_text()
    if tables.rewritten(text, tables.read(numbers)) == text:
        return 0
    print(f"{arguments.reproduction}: tables that do not fit reproduction.csv; run make table1")
    return 1


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("command", choices=["run", "check"])
    parser.add_argument("--program")
    parser.add_argument("--program-O0", dest="program_O0")
    parser.add_argument("--de1sim")
    parser.add_argument("--elf")
    parser.add_argument("--scenario")
    parser.add_argument("--gnuplot")
    parser.add_argument("--out", type=pathlib.Path)
    parser.add_argument("--reproduction", type=pathlib.Path, required=True)
    arguments = parser.parse_args()
    return run(arguments) if arguments.command == "run" else check(arguments)


sys.exit(main())
