"""processors.py DE1SIM ARM_GCC RISCV_GCC EXAMPLES FOLDER - instructions per second of a loop that
stores (stores.c): on the ARM, on Nios V, and the latter in QEMU, by processor time.

Clocks per instruction are a tenth of the usual, so that the board's own share of a run is small; a
run of few rounds is taken off each.  Exit code 1 if they do not print the same.
"""
import json
import os
import pathlib
import shutil
import statistics
import subprocess
import sys

from waiting_programs import processor_s

TIMES = 5
ROUNDS, FEW = 36_000, 36
SOURCE = pathlib.Path(__file__).resolve().parent / "stores.c"
RISCV = ["-march=rv32im", "-misa-spec=2.2", "-mabi=ilp32", "-nostdlib"]


def main():
    de1sim, arm_gcc, riscv_gcc, examples, folder = sys.argv[1:6]
    os.makedirs(folder, exist_ok=True)

    def elf(name, compiler, flags, rounds):
        path = os.path.join(folder, f"{name}_{rounds}.elf")
        subprocess.run([compiler, "-O1", "-ffreestanding", "-w", f"-DROUNDS={rounds}",
                        f"-I{examples}", "-Wl,--no-warn-rwx-segments", SOURCE, *flags,
                        "-o", path], check=True)
        return path

    def on_board(cpi):
        return lambda path: [de1sim, "run", "--quiet", "--frames", "none", "--cpi", cpi,
                             "--out", os.path.join(folder, "out"), "--elf", path]

    machines = {
        "the ARM": (on_board("0.1"), arm_gcc, [
            "-mcpu=cortex-a9", "-mfpu=neon", "-mfloat-abi=softfp", "-nostartfiles",
            f"-T{examples}/program.ld", f"{examples}/start.S"]),
        "Nios V": (on_board("0.1"), riscv_gcc, [
            *RISCV, f"-T{examples}/nios_v.ld", f"{examples}/nios_v.S", "-lgcc"]),
    }
    qemu = shutil.which("qemu-riscv32")
    if qemu:
        machines["QEMU"] = (lambda path: [qemu, path], riscv_gcc, [*RISCV, "-DLINUX"])

    programs, counts, printed = {}, {}, {}
    for name, (command, compiler, flags) in machines.items():
        programs[name] = [command(elf(name.replace(" ", "_"), compiler, flags, rounds))
                          for rounds in (ROUNDS, FEW)]
        counts[name] = []
        for program in programs[name]:
            output = subprocess.run(program, check=True, stdout=subprocess.PIPE,
                                    stderr=subprocess.DEVNULL, encoding="utf-8").stdout
            if name != "QEMU":
                with open(os.path.join(folder, "out", "report.json"), encoding="utf-8") as file:
                    counts[name].append(json.load(file)["program"]["instructions"])
                output = pathlib.Path(folder, "out", "console.txt").read_text(encoding="utf-8")
            printed.setdefault(name, []).append(output)
    counts["QEMU"] = counts["Nios V"]  # the same code

    took_s = {name: [] for name in machines}
    for _ in range(TIMES):
        for name, (long_run, short_run) in programs.items():
            took_s[name].append(processor_s(long_run) - processor_s(short_run))
    for name, times in took_s.items():
        many, few = counts[name]
        print(f"{(many - few) / 1e6:.0f} million instructions of a loop that stores, {name}: "
              f"{(many - few) / statistics.median(times) / 1e6:.0f} million/s")
    if len({tuple(output) for output in printed.values()}) != 1:
        print(f"what they print differs: {printed}")
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
