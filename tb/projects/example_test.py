"""example_test.py DE1SIM EXAMPLE FOLDER [STARTUP] - builds and plays the projects in a folder.

Each is NAME.qsf, on which NAME.yaml is played.  Its program NAME.c, if it has one, is linked with
the start-up in that folder.  In a copy at a path with a blank and a letter that is not ASCII; then
the same again, which must not build anything.
"""
import pathlib
import shutil
import subprocess
import sys

de1sim, example, folder = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
copy = folder / "a project \u00e9" / example.name
shutil.rmtree(copy, ignore_errors=True)
shutil.copytree(example, copy, ignore=shutil.ignore_patterns(".de1sim"))
for project in sorted(copy.glob("*.qsf")):
    name = project.stem
    if (copy / f"{name}.c").exists():
        startup = pathlib.Path(sys.argv[4])
        subprocess.run(["arm-none-eabi-gcc", "-std=c99", "-mcpu=cortex-a9", "-mgeneral-regs-only",
                        "-mno-unaligned-access", "-O1", "-ffreestanding", "-Wall", "-Wextra",
                        "-Werror", "-nostartfiles", f"-T{startup / 'program.ld'}",
                        startup / "start.S", f"{name}.c", "-o", f"{name}.elf"],
                       cwd=copy, check=True)
    played = subprocess.run([de1sim, "run", f"{name}.yaml", "--project", project.name], cwd=copy)
    if played.returncode != 0:
        sys.exit(played.returncode)
    again = subprocess.run([de1sim, "build", project.name], cwd=copy, capture_output=True,
                           text=True)
    said = [line for line in again.stderr.splitlines() if "as Quartus would give" not in line]
    if "is up to date" not in again.stdout or said:
        sys.exit(f"built again: {again.stdout}{again.stderr}")
