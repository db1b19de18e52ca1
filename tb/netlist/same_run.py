"""same_run.py DE1SIM OTHER SCENARIO OUT [--differs] - two de1sims, one scenario, the same bytes?

Compares every picture, the sound, the console and the report but for its wall time.  0 if they are
the same, with --differs if they are not.
"""
import json
import pathlib
import shutil
import subprocess
import sys


def files(folder):
    found = {}
    for path in sorted(p for p in folder.rglob("*") if p.is_file()):
        name = str(path.relative_to(folder))
        found[name] = path.read_bytes()
        if name == "report.json":
            report = json.loads(found[name])
            report.pop("wall", None)
            found[name] = json.dumps(report, sort_keys=True)
    return found


def main():
    programs, scenario, out = sys.argv[1:3], sys.argv[3], pathlib.Path(sys.argv[4])
    shutil.rmtree(out, ignore_errors=True)
    codes, runs = [], []
    for name, program in zip(("verilog", "netlist"), programs):
        done = subprocess.run([program, "run", "--quiet", "--frames", "all", "--out",
                               str(out / name), scenario])
        codes.append(done.returncode)
        runs.append(files(out / name))
    if codes[0] != 0 or not any(name.endswith(".png") for name in runs[0]):
        sys.exit(f"{programs[0]} failed with {codes[0]} or made no picture")
    names = sorted(set(runs[0]) | set(runs[1]))
    different = [name for name in names if runs[0].get(name) != runs[1].get(name)]
    print(f"{len(names)} files, {len(different)} different: {' '.join(different[:5])}")
    print(f"exit codes {codes[0]} and {codes[1]}")
    same = not different and codes[0] == codes[1]
    sys.exit(same if "--differs" in sys.argv else not same)


main()
