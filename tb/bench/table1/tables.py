"""tables.py - from the numbers that table1_measure wrote to tables in Markdown."""
import csv
import io
import re

HEADER = ("build,size,shape,inserted,algorithm,clock_ms,fine_ms,low_ms,high_ms,uncertainty,batches,"
          "settled,box_tests,interval_pairs,polygon_tests,line_tests,copies,pairs\n")
SHAPES = ["square", "X"]
COUNTS = [1, 10, 100, 200]

# The paper's Table 1: ms per tick, and the factor.
PAPER = {("square", 1): (0.133668, 0.0506073, 2.6), ("square", 10): (1.57945, 0.110429, 14.3),
         ("square", 100): (90.6606, 2.97351, 30.5), ("square", 200): (195.187, 9.15208, 21.3),
         ("X", 1): (0.241546, 0.0365497, 6.6), ("X", 10): (12.4563, 0.202086, 61.7),
         ("X", 100): (577.627, 2.44561, 236.2), ("X", 200): (1336.33, 11.396, 117.3)}

# What the best algorithm must reach against `original`.
WANTED = {1: {"square": 1, "X": 1}, 10: {"square": 4, "X": 4}, 100: {"square": 8, "X": 6},
          200: {"square": 8, "X": 6}}
BEST = "simd"


def read(text):
    """Rows by (build, size, shape, inserted, algorithm)."""
    return {(row["build"], int(row["size"]), row["shape"], int(row["inserted"]), row["algorithm"]):
            row for row in csv.DictReader(io.StringIO(text))}


def algorithms(cells, build):
    return list(dict.fromkeys(key[4] for key in cells if key[0] == build))


def ms(cells, build, size, shape, count, algorithm):
    return float(cells[build, size, shape, count, algorithm]["fine_ms"])


def number(value):
    return f"{value:.3g}" if value < 1000 else f"{value:.0f}"


def table(head, rows):
    lines = [head, ["---"] * len(head)] + rows
    return "".join("| " + " | ".join(str(cell) for cell in line) + " |\n" for line in lines)


def each(row):
    return [row(shape, count) for shape in SHAPES for count in COUNTS]


def table1(cells):
    """The paper's columns, ours by std::clock and by the finer clock, and the paper's own."""
    def row(shape, count):
        ours = [cells["optimised", 16, shape, count, name] for name in ("original", "improved")]
        fine = [float(cell["fine_ms"]) for cell in ours]
        return ([shape, count] + [f"{float(cell['clock_ms']):.6f}" for cell in ours]
                + [f"{value:.6f}" for value in fine] + [f"{fine[0] / fine[1]:.2f}"]
                + list(PAPER[shape, count]))
    head = ["Shape", "Inserted", "Original, ms", "Improved, ms", "Original, finer clock",
            "Improved, finer clock", "Factor", "Paper: original", "Paper: improved",
            "Paper: factor"]
    return table(head, each(row)) + "\n" + all_algorithms(cells)


def all_algorithms(cells):
    """Microseconds per tick, and half the interquartile range of the readings in percent."""
    names = algorithms(cells, "optimised")

    def entry(cell):
        median, low, high = (float(cell[key]) for key in ("fine_ms", "low_ms", "high_ms"))
        mark = "" if cell["settled"] == "yes" else " ?"
        return f"{number(1000 * median)} +-{50 * (high - low) / median:.0f} %{mark}"

    def row(shape, count):
        return [shape, count] + [entry(cells["optimised", 16, shape, count, name])
                                 for name in names]
    return table(["us per tick", "Inserted"] + names, each(row))


READINGS = [("optimised", 16), ("-O0", 16), ("-O0", 8)]
ORIGINALS = ["original", "original_all_lines", "original_by_copy"]


def readings(cells):
    """original / improved for each reading of the original and setting."""
    def row(shape, count):
        line = [shape, count, PAPER[shape, count][2]]
        for build, size in READINGS:
            improved = ms(cells, build, size, shape, count, "improved")
            line += [number(ms(cells, build, size, shape, count, name) / improved)
                     for name in ORIGINALS]
        return line
    head = ["Shape", "Inserted", "Paper"] + [f"{name}, {build}, {size} px"
                                             for build, size in READINGS for name in ORIGINALS]
    return table(head, each(row))


def nearest(cells):
    """The paper's factors relative to those of the reading with the largest."""
    away = [PAPER[shape, count][2] * ms(cells, "-O0", 8, shape, count, "improved")
            / ms(cells, "-O0", 8, shape, count, "original_by_copy")
            for shape in SHAPES for count in COUNTS]
    return (f"The paper's factors are {min(away):.1f} to {max(away):.1f} times those of "
            "`original_by_copy` at -O0 with 8 pixels.\n")


def operations(cells):
    """What each algorithm does in a tick, counted."""
    columns = ["box_tests", "interval_pairs", "polygon_tests", "line_tests", "copies", "pairs"]
    names = algorithms(cells, "optimised")
    rows = [[shape, 100, name] + [number(float(cells["optimised", 16, shape, 100, name][column]))
                                  for column in columns] for shape in SHAPES for name in names]
    return table(["Shape", "Inserted", "Algorithm"] + [c.replace("_", " ") for c in columns], rows)


def best(cells):
    """The best algorithm against both originals, with what was wanted."""
    def row(shape, count):
        fastest = ms(cells, "optimised", 16, shape, count, BEST)
        against = ms(cells, "optimised", 16, shape, count, "original") / fastest
        copies = ms(cells, "optimised", 16, shape, count, "original_by_copy") / fastest
        wanted, paper = WANTED[count][shape], PAPER[shape, count][2]
        return [shape, count, f"{against:.1f}", wanted, "met" if against >= wanted else "MISSED",
                f"{copies:.1f}", paper, "met" if copies > paper else "MISSED"]
    return table(["Shape", "Inserted", f"original / {BEST}", "Wanted", "",
                  f"original_by_copy / {BEST}", "Paper's factor", ""], each(row))


CLOCK_MHZ = 800  # of the modelled A9, one instruction per clock


def board_rows(console):
    """Rows for the CSV from the lines that collide.elf prints: shape,inserted,algorithm,ns."""
    rows = []
    for line in console.splitlines():
        if line.count(",") == 3:
            shape, inserted, algorithm, ns = line.split(",")
            time = f"{int(ns) / 1e6:.7f}"
            rows.append(f"board,16,{shape},{inserted},{algorithm}," + f"{time}," * 4
                        + "0,1,yes,,,,,,\n")
    return "".join(rows)


def board(cells):
    """The paper's columns on the modelled A9."""
    def row(shape, count):
        ours = [ms(cells, "board", 16, shape, count, name)
                for name in ("original", "original_all_lines", "improved", BEST)]
        original, all_lines, improved, fastest = ours
        return ([shape, count] + [f"{value:.6f}" for value in ours]
                + [f"{original / improved:.2f}", f"{all_lines / improved:.1f}"]
                + list(PAPER[shape, count]))
    head = ["Shape", "Inserted", "original, ms", "original_all_lines, ms", "improved, ms",
            f"{BEST}, ms", "original / improved", "original_all_lines / improved",
            "Paper: original", "Paper: improved", "Paper: factor"]
    return table(head, each(row))


def board_instructions(cells):
    """Thousands of instructions per tick on the modelled A9."""
    names = algorithms(cells, "board")

    def row(shape, count):
        return [shape, count] + [number(ms(cells, "board", 16, shape, count, name) * CLOCK_MHZ)
                                 for name in names]
    return table(["1000 instructions", "Inserted"] + names, each(row))


targets = best
BLOCKS = {"board": board, "board_instructions": board_instructions,
          "all": all_algorithms, "readings": readings, "nearest": nearest,
          "operations": operations, "best": best}


def rewritten(text, cells):
    """`text` with each block between <!-- table NAME --> and <!-- end --> made again."""
    def block(match):
        return f"{match[1]}\n{BLOCKS[match[2]](cells)}<!-- end -->"
    return re.sub(r"(<!-- table (\w+) -->)\n.*?<!-- end -->", block, text, flags=re.S)
