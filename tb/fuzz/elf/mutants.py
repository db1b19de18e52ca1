#!/usr/bin/env python3
"""mutants.py DE1SIM FOLDER [--count N] [--seed S] ELF...: damaged programs must not harm de1sim.

Each mutant is one of the ELFs with a few bytes changed: in its headers, in its code, or anywhere.
de1sim runs each for some simulated milliseconds and must end by itself with 0 (nothing was hit),
1 (the program failed) or 2 (no program), never by a signal and never too late.  Mutants that do
otherwise are kept in FOLDER; the same seed makes the same ones again.
"""
import argparse
import concurrent.futures
import pathlib
import random
import subprocess
import sys

SCENARIO = "name: mutant\nversion: 1\nduration: 3ms\nsteps:\n  - delay: 1ms\n"
LIMIT_S = 120  # a hang; a run takes a second
HEADERS = 0x200


def damage(elf, random_):
    data = bytearray(elf)
    begin, end = random_.choice([(0, HEADERS), (0x1000, 0x9000), (0, len(data))])
    for _ in range(random_.choice([1, 4, 16, 64, 256, 1024])):
        at = random_.randrange(begin, min(end, len(data)))
        flipped = data[at] ^ 1 << random_.randrange(8)
        data[at] = random_.choice([0, 0xFF, random_.randrange(256), flipped])
    return data


def main():
    arguments = argparse.ArgumentParser()
    arguments.add_argument("de1sim")
    arguments.add_argument("folder", type=pathlib.Path)
    arguments.add_argument("elf", nargs="+", type=pathlib.Path)
    arguments.add_argument("--count", type=int, default=600)
    arguments.add_argument("--seed", type=int, default=1)
    options = arguments.parse_args()
    options.folder.mkdir(parents=True, exist_ok=True)
    scenario = options.folder / "mutant.yaml"
    scenario.write_text(SCENARIO)
    originals = [elf.read_bytes() for elf in options.elf]

    def run(number):
        random_ = random.Random(options.seed * 1_000_003 + number)
        mutant = options.folder / f"mutant_{number}.elf"
        mutant.write_bytes(damage(originals[number % len(originals)], random_))
        out = options.folder / f"out_{number}"
        command = [options.de1sim, "run", scenario, "--cpu", "arm", "--elf", mutant, "--out", out,
                   "--frames", "none", "--quiet"]
        try:
            done = subprocess.run(command, capture_output=True, timeout=LIMIT_S, text=True,
                                  errors="replace", check=False)
            code, said = done.returncode, done.stderr
        except subprocess.TimeoutExpired:
            code, said = "no end", ""
        fine = code in (0, 1, 2) and "internal error" not in said
        if fine:
            mutant.unlink()
        subprocess.run(["rm", "-rf", out], check=True)
        return number, code, fine, said.strip().splitlines()[-1:]

    counts, bad = {}, []
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        for number, code, fine, said in pool.map(run, range(options.count)):
            counts[code] = counts.get(code, 0) + 1
            if not fine:
                bad.append(number)
                print(f"mutant {number}: {code}: {' '.join(said)}", flush=True)
    print("exit codes: " + ", ".join(f"{code}: {n}" for code, n in sorted(counts.items(), key=str)))
    print(f"{options.count - len(bad)} of {options.count} mutants did no harm")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
