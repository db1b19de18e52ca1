#!/usr/bin/env python3
"""run.py FUZZERS FOLDER SEEDS [--seconds S] [--runs N] [TARGET...]: libFuzzer's targets, in turn.

FUZZERS has the programs fuzz_TARGET, which all run if no TARGET is named; SEEDS has the folders
TARGET/seeds.  FOLDER/TARGET keeps what was found, so that the next time goes on from there.  An
input that crashes, hangs or breaks a promise is left in FOLDER/TARGET-found, and its path is
printed.  A line per target at the end; exit code 1 if any has found something.  FOLDER/runs.tsv
gets a line each time: target, runs and the seconds they took, to be added up.
"""
import argparse
import os
import pathlib
import re
import resource
import subprocess
import sys
import tempfile
import time

MOST_BYTES = {"elf": 1000, "collision": 300, "png": 600, "gdb": 600, "qsys": 800}
ORDINARY = 400  # of the others.  Longer inputs run less often; longer seeds are cut
LIMIT_S, LIMIT_MB = 10, 1024  # of one input
# AddressSanitizer keeps freed memory back to find its use: 1 MB here, because its usual 256 MB cost
# more time in cache misses than all else.  Nor does it note the calls that led to an allocation:
# to see them, run fuzz_TARGET by hand on what was found.
QUICK = "malloc_context_size=0:quarantine_size_mb=1:thread_local_quarantine_size_kb=64"


def fuzz(target, options, left, seconds):
    """Runs and their number, until `left` are done or something was found; 0 and -1: no limit."""
    corpus, found = options.folder / target, options.folder / f"{target}-found"
    command = [options.fuzzers / f"fuzz_{target}", f"-max_len={MOST_BYTES.get(target, ORDINARY)}",
               f"-timeout={LIMIT_S}", f"-rss_limit_mb={LIMIT_MB}", "-print_final_stats=1",
               "-report_slow_units=1000",  # seconds; what is slow and ends is not kept as found
               f"-artifact_prefix={found}/", f"-max_total_time={seconds}",
               f"-runs={left}", "-reload=0"]  # nobody else writes to the corpus
    environment = {"ASAN_OPTIONS": QUICK, **os.environ}
    with tempfile.TemporaryDirectory() as empty:  # where nothing is to be written
        done = subprocess.run([*command, corpus, options.seeds / target / "seeds"], cwd=empty,
                              env=environment, capture_output=True, text=True, errors="replace",
                              check=False)
        littered = any(pathlib.Path(empty).iterdir())
    if done.returncode or littered:
        done.said = [line for line in done.stderr.splitlines() if not re.match(r"#\d+\t", line)]
        done.said.append(f"{target}: ended with {done.returncode}" + ", wrote files" * littered)
    done.bad = bool(done.returncode or littered)
    counted = re.findall(r"number_of_executed_units: (\d+)", done.stderr) or [0]
    return done, int(counted[-1])


def hangs(program, path):
    """libFuzzer's limit is one of the clock, which goes on while the machine does other things."""
    def used():
        children = resource.getrusage(resource.RUSAGE_CHILDREN)
        return children.ru_utime + children.ru_stime
    before = used()
    again = subprocess.run([program, f"-timeout={100 * LIMIT_S}", path], capture_output=True,
                           check=False)
    return again.returncode != 0 or used() - before > LIMIT_S


def run(target, options):
    corpus, found = options.folder / target, options.folder / f"{target}-found"
    for folder in (corpus, found):
        folder.mkdir(parents=True, exist_ok=True)
    before = set(found.iterdir())
    begin = time.monotonic()
    runs, took = 0, 0
    while True:
        left = options.runs - runs if options.runs >= 0 else -1
        seconds = max(1, options.seconds - int(took)) if options.seconds else 0
        start = time.monotonic()
        done, more = fuzz(target, options, left, seconds)
        runs, took = runs + more, time.monotonic() - begin
        with open(options.folder / "runs.tsv", "a", encoding="utf-8") as table:
            table.write(f"{target}\t{more}\t{time.monotonic() - start:.0f}\n")
        new = sorted(set(found.iterdir()) - before)
        late = [path for path in new if path.name.startswith("timeout-")]
        if not late or len(new) > 1 or hangs(options.fuzzers / f"fuzz_{target}", late[0]):
            break
        late[0].unlink()
    if done.bad:
        print("\n".join(done.said[-60:]))
    for path in new:
        print(f"{target}: found {path}")
    kept = sum(1 for _ in corpus.iterdir())
    speed = runs / max(took, 1)
    return done.bad, f"{target:10} {runs:10} runs {speed:7.0f} per s {kept:6} kept " \
                     f"{int(done.bad)} crashes"


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
