#!/usr/bin/env python3
"""run.py FUZZERS FOLDER SEEDS [--seconds S] [--runs N] [TARGET...]: libFuzzer's targets, in turn.

FUZZERS has the programs fuzz_TARGET, which all run if no TARGET is named; SEEDS has the folders
TARGET/seeds.  FOLDER/TARGET keeps what was found, so that the next time goes on from there.  An
input that crashes, hangs or breaks a promise is left in FOLDER/TARGET-found, and its path is
printed.  A line per target at the end; exit code 1 if any has found something.
"""
import argparse
import pathlib
import re
import subprocess
import sys
import tempfile

MOST_BYTES = {"elf": 3000, "collision": 1500, "png": 600, "live": 1000, "gdb": 2000}
ORDINARY = 1000  # of the others: the longer, the fewer runs per second
LIMIT_S, LIMIT_MB = 10, 1024  # of one input


def run(target, options):
    corpus, found = options.folder / target, options.folder / f"{target}-found"
    for folder in (corpus, found):
        folder.mkdir(parents=True, exist_ok=True)
    before = set(found.iterdir())
    command = [options.fuzzers / f"fuzz_{target}", f"-max_len={MOST_BYTES.get(target, ORDINARY)}",
               f"-timeout={LIMIT_S}", f"-rss_limit_mb={LIMIT_MB}", "-print_final_stats=1",
               f"-artifact_prefix={found}/", f"-max_total_time={options.seconds}",
               f"-runs={options.runs}"]
    with tempfile.TemporaryDirectory() as empty:  # where nothing is to be written
        done = subprocess.run([*command, corpus, options.seeds / target / "seeds"], cwd=empty,
                              capture_output=True, text=True, errors="replace", check=False)
        littered = any(pathlib.Path(empty).iterdir())
    new = sorted(set(found.iterdir()) - before)
    if done.returncode or littered:
        said = [line for line in done.stderr.splitlines() if not re.match(r"#\d+\t", line)]
        print("\n".join(said[-60:]))
        print(f"{target}: ended with {done.returncode}" + ", wrote files" * littered)
    for path in new:
        print(f"{target}: found {path}")
    runs = int((re.findall(r"number_of_executed_units: (\d+)", done.stderr) or [0])[-1])
    speed = (re.findall(r"average_exec_per_sec: +(\d+)", done.stderr) or ["?"])[-1]
    kept = sum(1 for _ in corpus.iterdir())
    bad = bool(done.returncode or littered)
    return bad, f"{target:10} {runs:10} runs {speed:>7} per s {kept:6} kept {int(bad)} crashes"


def main():
    arguments = argparse.ArgumentParser()
    for folder in ("fuzzers", "folder", "seeds"):
        arguments.add_argument(folder, type=lambda text: pathlib.Path(text).resolve())
    arguments.add_argument("--seconds", type=int, default=0, help="0: no limit")
    arguments.add_argument("--runs", type=int, default=-1, help="-1: no limit")
    arguments.add_argument("targets", nargs="*")
    options = arguments.parse_intermixed_args()
    targets = options.targets or sorted(program.name[5:] for program in
                                        options.fuzzers.glob("fuzz_*"))
    results = [run(target, options) for target in targets]
    print("\n".join(line for _, line in results))
    return 1 if any(bad for bad, _ in results) else 0


if __name__ == "__main__":
    sys.exit(main())
