"""fits.py FOLDER KEPT [--keep] - what the netlist uses of the 5CSEMA5F31C6, and the limits.

FOLDER holds Yosys' cells.txt, check.txt and yosys.log.  Fails above 80 % of what the device has, on
a latch, a combinational loop, a memory that did not become M10Ks, and on growth by more than 5 %
over the numbers kept in KEPT (--keep writes them again).

ALMs are bounded from above, as nothing is placed: a table of 5 or 6 inputs takes one, of fewer a
half, an adder bit a half.  Four registers fit into an ALM.
"""
import json
import pathlib
import re
import sys

HAS = {"ALMs": 32070, "registers": 128280, "M10Ks": 397, "DSPs": 87}
LIMIT, GROWTH = 0.80, 1.05


def counted(folder):
    text = (folder / "cells.txt").read_text()
    cells = {name: int(n) for name, n in re.findall(r"^ +(\S+) +(\d+)$", text, re.M)}
    halves = sum(cells.get(f"MISTRAL_{name}", 0)
                 for name in ("ALUT2", "ALUT3", "ALUT4", "NOT", "ALUT_ARITH"))
    whole = cells.get("MISTRAL_ALUT5", 0) + cells.get("MISTRAL_ALUT6", 0)
    registers = cells.get("MISTRAL_FF", 0)
    return {"ALMs": max(whole + (halves + 1) // 2, (registers + 3) // 4),
            "registers": registers, "M10Ks": cells.get("MISTRAL_M10K", 0),
            "DSPs": sum(n for name, n in cells.items() if name.startswith("MISTRAL_MUL")),
            "bits in MLABs": cells.get("MISTRAL_MLAB", 0)}


def complaints(folder, used, kept):
    for name, has in HAS.items():
        if used[name] > LIMIT * has:
            yield f"{used[name]} {name} are more than {LIMIT:.0%} of {has}"
    for name, was in kept.items():
        if used[name] > GROWTH * was:
            yield f"{name} grew from {was} to {used[name]}: make it less or run fits.py --keep"
    if used["bits in MLABs"]:
        yield f"{used['bits in MLABs']} memory cells are MLABs, not M10Ks"
    log = (folder / "yosys.log").read_text()
    yield from re.findall(r"^Latch inferred for .*$", log, re.M)
    yield from re.findall(r"^Mapping memory .*$", log, re.M)    # to registers
    if "Found and reported 0 problems" not in (folder / "check.txt").read_text():
        yield "check: " + (folder / "check.txt").read_text().strip()


def main():
    if len(sys.argv) < 3 or not (pathlib.Path(sys.argv[1]) / "cells.txt").is_file():
        sys.exit(__doc__ if len(sys.argv) < 3 else f"{sys.argv[1]}: no netlist was made")
    folder, kept_file = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    used = counted(folder)
    if "--keep" in sys.argv:
        kept_file.write_text(json.dumps(used, indent=4) + "\n")
    kept = json.loads(kept_file.read_text())
    print(f"{'':10} {'used':>8} {'device':>8} {'':>7} {'kept':>8}")
    for name, n in used.items():
        has = HAS.get(name)
        share = f"{has:>8} {n / has:7.1%}" if has else " " * 16
        print(f"{name:10} {n:>8} {share} {kept[name]:>8}")
    found = list(complaints(folder, used, kept))
    print("\n".join(found))
    return 1 if found else 0


sys.exit(main())
