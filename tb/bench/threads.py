"""threads.py DE1SIM SWITCHES FOLDER - what threads of a Linux program cost, by processor time.

SWITCHES (tb/programs/linux/switches.c) computes in one, two and eight threads, in turn, a few times
over; exit 1 if the instructions per second of two or eight are less than LEAST of those of one.
Then it prints the switches per second between two threads.  A short run is taken off each.
"""
import json
import os
import statistics
import sys

from waiting_programs import processor_s

LEAST = 0.9
TIMES = 5
ROUNDS, SIGNALS, YIELDS = 100_000_000, 40_000, 200_000


def main():
    de1sim, switches, folder = sys.argv[1:4]

    def took_s(*arguments):
        return processor_s([de1sim, "run", "--quiet", "--frames", "none", "--out", folder,
                            "--elf", switches, "--", *map(str, arguments)])

    def instructions():
        with open(os.path.join(folder, "report.json"), encoding="utf-8") as file:
            return json.load(file)["program"]["instructions"]

    measured = {"one": [], "two": [], "eight": [], "signal": [], "yield": []}
    for _ in range(TIMES):
        start_s = took_s("yield", 1)
        for name, threads in ("one", 1), ("two", 2), ("eight", 8):
            measured[name].append((took_s("compute", ROUNDS, threads) - start_s) / instructions())
        measured["signal"].append(took_s("signal", SIGNALS) - start_s)
        measured["yield"].append(took_s("yield", YIELDS) - start_s)
    middle = {name: statistics.median(values) for name, values in measured.items()}
    ratios = {name: middle["one"] / middle[name] for name in ("two", "eight")}
    print(f"arithmetic of Linux: {1e-6 / middle['one']:.0f} million instructions/s in "
          f"one thread, {ratios['two']:.2f} times that in two, {ratios['eight']:.2f} in eight, "
          f"at least {LEAST}: {'met' if min(ratios.values()) >= LEAST else 'MISSED'}")
    print(f"switches/s between two threads: {2 * SIGNALS / middle['signal']:.0f} by a condition "
          f"variable, {2 * YIELDS / middle['yield']:.0f} by sched_yield()")
    return 0 if min(ratios.values()) >= LEAST else 1


if __name__ == "__main__":
    sys.exit(main())
