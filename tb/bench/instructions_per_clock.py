"""instructions_per_clock.py - host instructions per fabric clock, counted by callgrind: no noise.

instructions_per_clock.py --most N FIRST SECOND CLOCKS -- COMMAND... {} ...

Runs COMMAND twice, FIRST and then SECOND in the place of {}, and divides the difference by CLOCKS,
by which the second run is longer.  Exit 1 if that is more than N.
"""
import argparse
import re
import subprocess
import sys


def instructions(command, value):
    command = [part.replace("{}", value) for part in command]
    done = subprocess.run(["valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null",
                           *command], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    count = re.search(r"refs: +([0-9,]+)", done.stdout)
    if done.returncode or not count:
        sys.exit(done.stdout)
    return int(count[1].replace(",", ""))


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--most", type=float, required=True)
    parser.add_argument("first")
    parser.add_argument("second")
    parser.add_argument("clocks", type=int)
    parser.add_argument("command", nargs="+")
    arguments = parser.parse_args()
    per_clock = (instructions(arguments.command, arguments.second)
                 - instructions(arguments.command, arguments.first)) / arguments.clocks
    met = per_clock <= arguments.most
    print(f"{per_clock:.0f} instructions per fabric clock, at most {arguments.most:.0f}: "
          f"{'met' if met else 'MISSED'}")
    return 0 if met else 1


sys.exit(main())
