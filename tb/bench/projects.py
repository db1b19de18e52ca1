"""projects.py DE1SIM EXAMPLES FOLDER - how fast the examples of people's projects run.

Prints the factor of real time of each, without a program, by processor time: of a run of RUN_S
without frames less one of a tenth of it, the median of three.  Then the least and the median.
"""
import os
import pathlib
import shutil
import statistics
import sys

from waiting_programs import processor_s

RUN_S, TIMES = 0.2, 3


def scenario(project, duration):
    path = project.with_name(f"{duration * 1e3:.0f}ms.yaml")
    path.write_text(f"name: nothing\nversion: 1\nproject: {project.name}\n"
                    f"steps:\n  - delay: {path.stem}\n", encoding="utf-8")
    return path


def main():
    de1sim, examples, folder = sys.argv[1], *map(pathlib.Path, sys.argv[2:4])
    shutil.rmtree(folder, ignore_errors=True)
    shutil.copytree(examples, folder)
    os.environ["XDG_CACHE_HOME"] = str(folder / "cache")
    speeds = []
    print("examples of projects: x real time")
    for project in sorted(folder.glob("*/*.qsf")):
        short, long = ([de1sim, "run", scenario(project, duration), "--quiet", "--frames", "none",
                        "--out", folder / "out"] for duration in (RUN_S / 10, RUN_S))
        processor_s(short)  # builds it
        taken = statistics.median(processor_s(long) - processor_s(short) for _ in range(TIMES))
        speeds.append(0.9 * RUN_S / taken)
        print(f"  {project.stem:30}  {speeds[-1]:5.2f} x", flush=True)
    print(f"  least {min(speeds):.2f} x, median {statistics.median(speeds):.2f} x real time")


if __name__ == "__main__":
    main()
