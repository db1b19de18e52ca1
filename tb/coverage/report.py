"""report.py DAT ROOT --info INFO LINES ARMS TOGGLES - coverage of ROOT/rtl as a table and for lcov.

DAT is what verilator_coverage merged.  Of its points, those of kind block, if, else, case name the
source lines that they guard: a line counts as covered if each point that guards it was reached.  A
toggle point is one direction-free change of one bit.  A module that is there several times, with
whatever parameters, counts once: points at one place are added up.

In INFO, lines are lines; arms of if and case, and toggles, are branches.
LINES, ARMS and TOGGLES are how many percent of each are to be covered; fails if one is not.
"""
import argparse
import collections
import pathlib
import posixpath
import sys

# Not of our FPGA; and a table of letters, whose arms Verilator turns into a memory without counting
# them (vga_text_test.cpp compares each letter).
NOT_COUNTED = ("rtl/ip/", "rtl/examples/", "rtl/vga/character_font.vh")


def points(dat):
    """Yields the fields of each point, by Verilator's short names, and its count."""
    for record in dat.read_text().splitlines():
        if record.startswith("C '"):
            key, count = record[3:].rsplit("' ", 1)
            fields = [field.split("\2", 1) for field in key.split("\1")[1:]]
            if all(len(field) == 2 for field in fields):  # not cut off, with the test that wrote it
                yield dict(fields), int(count)


def guarded_lines(ranges):
    """"63-65,70" -> 63, 64, 65, 70"""
    for part in filter(None, ranges.split(",")):
        first, _, last = part.partition("-")
        yield from range(int(first), int(last or first) + 1)


class File:
    def __init__(self):
        self.guards = collections.Counter()    # (place, lines that it guards) -> count
        self.branches = collections.Counter()  # (line, column, arm) -> count
        self.toggles = collections.Counter()   # (line, signal) -> count

    def add(self, point, count):
        line, column, what = int(point["l"]), int(point["n"]), point["o"]
        kind = point["page"].split("/")[0]
        if kind == "v_toggle":
            self.toggles[line, what] += count
            return
        if kind == "v_branch":
            self.branches[line, column, what] += count
        self.guards[line, column, what, point.get("S", "")] += count

    def lines(self):
        counts = {}
        for (*_, ranges), count in self.guards.items():
            for line in guarded_lines(ranges):
                counts[line] = min(counts.get(line, count), count)
        return counts

    def write_info(self, out, path):
        out.write(f"TN:\nSF:{path}\n")
        arms = list(self.branches.items()) + list(self.toggles.items())
        for number, ((line, *_), count) in enumerate(sorted(arms, key=lambda arm: arm[0][0])):
            out.write(f"BRDA:{line},0,{number},{count}\n")
        for line, count in sorted(self.lines().items()):
            out.write(f"DA:{line},{count}\n")
        out.write("end_of_record\n")


def hits(counts):
    return sum(count > 0 for count in counts), len(counts)


def cell(hit, total):
    return f"{hit:6} of {total:5} {100 * hit / total:6.1f} %" if total else f"{'-':>24}"


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("dat", type=pathlib.Path)
    parser.add_argument("root", type=pathlib.Path)
    parser.add_argument("--info", type=pathlib.Path, required=True)
    parser.add_argument("floors", type=float, nargs=3, metavar="PERCENT")
    arguments = parser.parse_args()

    files = collections.defaultdict(File)
    for point, count in points(arguments.dat):
        path = posixpath.normpath(point["f"])
        while path.startswith("../"):
            path = path[3:]
        if path.startswith("rtl/") and not path.startswith(NOT_COUNTED):
            files[path].add(point, count)

    table = []
    missed = []
    with arguments.info.open("w") as info:
        sources = (arguments.root / "rtl").rglob("*.v*")
        for path in sorted(str(p.relative_to(arguments.root)) for p in sources):
            if path.startswith(NOT_COUNTED):
                continue
            file = files[path]
            file.write_info(info, arguments.root / path)
            lines = file.lines()
            missed += [f"{path}:{line}" for line, count in sorted(lines.items()) if count == 0]
            table.append((path, hits(lines.values()), hits(file.branches.values()),
                          hits(file.toggles.values())))
    total = ("all", *(tuple(map(sum, zip(*column))) for column in list(zip(*table))[1:]))

    print(f"{'':28}{'lines':>24}  {'arms of if and case':>24}  {'toggles':>24}")
    for name, *cells in table + [total]:
        print(f"{name:28}" + "  ".join(cell(*c) for c in cells))
    if missed:
        print("lines never reached: " + " ".join(missed))
    for what, (hit, count), floor in zip(("lines", "arms", "toggles"), total[1:], arguments.floors):
        if count == 0 or 100 * hit < floor * count:
            sys.exit(f"fewer than {floor:g} % of the {what} of rtl/ are covered")


main()
