"""history.py FOLDER -- COMMAND... - a run of the benchmarks, kept and compared with last week's.

Appends the ratios that COMMAND prints (speed by that of something in the same run, so that machines
and their load count little) to FOLDER/history.jsonl, and draws FOLDER/history.svg (gnuplot).
Exit code 1: a ratio is lower by a tenth than the median of what was kept 6 to 8 days before, or
COMMAND has failed.
"""
import json
import pathlib
import re
import statistics
import subprocess
import sys
import time

LINE = re.compile(r"  (\S.*?)  +[\d.]+ frames/s, [\d.]+ x real time; ([\d.]+) ")
DAY_S, LESS = 24 * 3600, 0.9


def run(command):
    """The ratios that it prints, by name, and its exit code."""
    ratios = {}
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as process:
        for line in process.stdout:
            print(line, end="", flush=True)
            if found := LINE.match(line):
                ratios[found[1]] = float(found[2])
    return ratios, process.returncode


def slower_than_last_week(history):
    """A line for each that is."""
    *before, now = history
    week = [one for one in before if 6 <= (now["time"] - one["time"]) / DAY_S <= 8]
    for name, ratio in now["ratios"].items():
        old = [one["ratios"][name] for one in week if name in one["ratios"]]
        if old and ratio < LESS * statistics.median(old):
            yield f"{name}: {ratio:.2f}, last week {statistics.median(old):.2f}"


def draw(history, file):
    names = sorted({name for one in history for name in one["ratios"]})
    blocks, plots = [], []
    for number, name in enumerate(names):
        points = [f"{one['time']:.0f} {one['ratios'][name]}" for one in history
                  if name in one["ratios"]]
        blocks.append(f"$ratio{number} << END\n" + "\n".join(points) + "\nEND\n")
        plots.append(f"$ratio{number} using 1:2 with linespoints title '{name}'")
    subprocess.run(["gnuplot"], text=True, check=True, input="".join(blocks) +
                   f"set terminal svg size 800,400\nset output '{file.name}'\n"
                   "set xdata time\nset timefmt '%s'\nset format x '%Y-%m-%d'\n"
                   "set ylabel 'speed, by that of the comparison in the same run'\n"
                   "set yrange [0:*]\nset key outside below\nplot " + ", ".join(plots) + "\n",
                   cwd=file.parent)


def main():
    folder, command = pathlib.Path(sys.argv[1]), sys.argv[3:]
    folder.mkdir(parents=True, exist_ok=True)
    file = folder / "history.jsonl"
    history = [json.loads(line) for line in file.read_text().splitlines()] if file.exists() else []
    ratios, code = run(command)
    if not ratios:
        sys.exit("history.py: the command has printed no ratio")
    history.append({"time": time.time(), "ratios": ratios})
    file.write_text("".join(json.dumps(one) + "\n" for one in history))
    draw(history, folder / "history.svg")
    slower = list(slower_than_last_week(history))
    for line in slower:
        print("slower than last week:", line)
    sys.exit(1 if slower or code else 0)


if __name__ == "__main__":
    main()
