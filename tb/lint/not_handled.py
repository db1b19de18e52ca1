"""not_handled.py ROOT [--write] - sim/NOT_HANDLED.md, the table of what is not modelled.

A row per header of sim/ and sw/ and per module of rtl/ whose comment has a paragraph "Not handled".
Without --write: exit 1 if the file is not what they say.
"""
import pathlib
import re
import sys

HEAD = """# What is not modelled

The largest: the processor's second core, its caches and its pipeline (every instruction takes
`--cpi` clocks); the time of an access to the SDRAM, unless `--fpga-memory bridge` is given; PAL at
the video input; Nios processors and encrypted IP in a project.

`make regmap` prints this table from the files' own comments, "Not handled".
"""


def row(path, root):
    """Title and paragraph, or None."""
    text = path.read_text()
    title = re.match(r"// \S+ - (.*(?:\n//  ?\S.*)*)", text)
    said = re.search(r"^//\s*Not handled([^\n]*(?:\n// *\S[^\n]*)*)", text, re.M)
    if not said or not title:
        return None

    def one_line(comment):
        return re.sub(r"\s*\n//\s*", " ", comment).strip().replace("|", "\\|")
    missing = re.sub(r"^:\s*", "", one_line(said[1]))
    where = path.relative_to(root)
    link = where.relative_to("sim") if where.parts[0] == "sim" else pathlib.Path("..") / where
    return f"| [{where}]({link}) | {one_line(title[1])} | {missing} |"


def table(root):
    found = []
    for folder, kind in (("sim", "*.h"), ("rtl", "*.v"), ("sw", "*.h")):
        found += [row(path, root) for path in sorted((root / folder).rglob(kind))]
    rows = [one for one in found if one]
    return "\n".join([HEAD, "| File | What it is | Not handled |", "|---|---|---|", *rows]) + "\n"


def main():
    root = pathlib.Path(sys.argv[1]).resolve()
    file = root / "sim" / "NOT_HANDLED.md"
    text = table(root)
    if "--write" in sys.argv:
        file.write_text(text)
    elif not file.exists() or file.read_text() != text:
        sys.exit(f"{file} is stale: make regmap")


main()
