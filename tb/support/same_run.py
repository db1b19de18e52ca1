"""same_run.py DE1SIM OTHER SCENARIO OUT [--differs] [OPTION...] - two de1sims, the same bytes?

Compares every picture, the sound, the console and the report but for its wall time.  0 if they are
the same, with --differs if they are not.  Further options go to both.
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
    options = [word for word in sys.argv[5:] if word != "--differs"]
    codes, runs = [], []
    for name, program in zip(("one", "other"), programs):
        done = subprocess.run([program, "run", "--quiet", "--frames", "all",
                               "--fpga-memory", "bridge", "--out", str(out / name), scenario,
                               *options])
        codes.append(done.returncode)
        runs.append(files(out / name))
    pictures = sum(name.endswith(".png") for name in runs[0])
    if codes[0] != 0 or (pictures == 0 and not options):  # a program need not show any
        sys.exit(f"{programs[0]} failed with {codes[0]} or made no picture")
    names = sorted(set(runs[0]) | set(runs[1]))
    different = [name for name in names if runs[0].get(name) != runs[1].get(name)]
    print(f"{len(names)} files, {len(different)} different: {' '.join(different[:5])}")
    print(f"exit codes {codes[0]} and {codes[1]}")
    same = not different and codes[0] == codes[1]
    sys.exit(same if "--differs" in sys.argv else not same)


main()
