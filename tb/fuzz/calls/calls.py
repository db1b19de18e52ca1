#!/usr/bin/env python3
"""calls.py DE1SIM PROGRAM FOLDER [--calls N] [--seed S]: system calls at random harm nothing.

de1sim runs PROGRAM, calls_at_random, with an empty folder as its root.  It must survive: end by
itself with 0.  What lies beside the root, in FOLDER, must be as it was.
"""
import argparse
import pathlib
import shutil
import subprocess
import sys
import time


def contents(folder):
    return {path: path.read_bytes() if path.is_file() else None for path in folder.rglob("*")}


def main():
    arguments = argparse.ArgumentParser()
    arguments.add_argument("de1sim")
    arguments.add_argument("program", type=pathlib.Path)
    arguments.add_argument("folder", type=pathlib.Path)
    arguments.add_argument("--calls", type=int, default=10_000_000)
    arguments.add_argument("--seed", type=int, default=1)
    arguments.add_argument("--limit", type=int, default=600, help="seconds; longer is a hang")
    options = arguments.parse_args()

    if options.folder.exists():
        subprocess.run(["chmod", "-R", "u+rwX", options.folder], check=True)
        shutil.rmtree(options.folder)
    root, beside, out = (options.folder / name for name in ("root", "beside", "out"))
    root.mkdir(parents=True)
    (beside / "outside").mkdir(parents=True)
    for name in ("outside/x", "a", "in"):
        (beside / name).write_text("as it was")
    shutil.copytree(beside / "outside", options.folder / "outside")
    before = contents(beside), contents(options.folder / "outside")

    command = [pathlib.Path(options.de1sim).resolve(), "run", "--cpu", "arm", "--elf",
               options.program.resolve(), "--quiet", "--frames", "none", "--system", "linux",
               "--out", out.resolve(), "--linux-root", root.resolve(), "--", str(options.calls),
               str(options.seed)]
    began = time.monotonic()
    try:
        done = subprocess.run(command, cwd=beside, capture_output=True, timeout=options.limit,
                              text=True, errors="replace", check=False)
        code, said = done.returncode, done.stderr.strip().splitlines()[-3:]
    except subprocess.TimeoutExpired:
        code, said = "no end", []
    took = time.monotonic() - began
    untouched = (contents(beside), contents(options.folder / "outside")) == before and \
        {path.name for path in options.folder.iterdir()} <= {"beside", "out", "outside", "root"}
    print(f"calls of seed {options.seed}: {options.calls}, {options.calls / took:.0f} a second")
    subprocess.run(["chmod", "-R", "u+rwX", root], check=True)
    if code != 0 or not untouched:
        print(f"exit code {code}, all but the root untouched: {untouched}")
        print("\n".join(said))
        return 1
    shutil.rmtree(options.folder)
    return 0


if __name__ == "__main__":
    sys.exit(main())
