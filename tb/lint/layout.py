"""layout.py ROOT - checks that no formatter does: characters, lengths, headers, default_nettype."""
import pathlib
import re
import sys

SUFFIXES = {".v", ".vh", ".def", ".h", ".cpp", ".py", ".cmake", ".txt", ".md", ".yaml", ".yml",
            ".json", ".sh", ".cmd", ".dts"}
TOP = ["rtl", "sw", "sim", "tb", ".ci", ".github"]
COLUMNS = 100
LINES = 500
# Made by a program, or a table whose rows say more on one line.
TABLES = {"regmap.def", "regmap.vh", "scenario.schema.json", "de1_soc.qsf"}


def sources(root):
    files = [p for p in root.iterdir() if p.is_file()]
    for top in TOP:
        files += (path for path in (root / top).rglob("*") if ".de1sim" not in path.parts)
    return sorted(p for p in files if p.is_file() and (p.suffix in SUFFIXES or p.name == "Makefile"
                                                       or p.parent.name == ".ci"))


def problems(path):
    """Yields (line, what)."""
    data = path.read_bytes()
    if not data.endswith(b"\n") or data.endswith(b"\n\n"):
        yield data.count(b"\n"), "does not end in one newline"
    lines = data.split(b"\n")[:-1]
    is_free = path.suffix == ".md" or path.name in TABLES
    for number, line in enumerate(lines, 1):
        if b"\r" in line:
            yield number, "carriage return"
        if b"\t" in line and path.name != "Makefile":
            yield number, "tab"
        if line.rstrip() != line:
            yield number, "trailing blanks"
        if any(byte > 126 for byte in line):
            yield number, "not ASCII"
        if len(line) > COLUMNS and not is_free:
            yield number, f"{len(line)} columns, more than {COLUMNS}"
    if len(lines) > LINES and not is_free:
        yield len(lines), f"{len(lines)} lines, more than {LINES}"

    header = f"// {path.name} - ".encode()
    if path.suffix in {".v", ".vh", ".h"} and not data.startswith(header):
        yield 1, f"does not begin with \"{header.decode()}\""
    if path.suffix == ".v" and "examples" not in path.parts:  # those are as a student writes them
        if not re.search(rb"^`default_nettype none$", data.split(b"\nmodule ")[0], re.M):
            yield 1, "no `default_nettype none before the module"
        if not data.endswith(b"\nendmodule\n\n`default_nettype wire\n"):
            yield len(lines), "does not end with endmodule and `default_nettype wire"


def main():
    root = pathlib.Path(sys.argv[1])
    files = sources(root)
    found = [(p, n, what) for p in files for n, what in problems(p)]
    for path, number, what in found:
        print(f"{path.relative_to(root)}:{number}: {what}")
    print(f"{len(files)} files, {len(found)} problems")
    return 1 if found or not files else 0


sys.exit(main())
