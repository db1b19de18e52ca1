# layers.py FILE - whether each folder of sim/ includes only what its libraries name.
#
# A line of the file is "folder: folder;folder", as sim_library() of sim/CMakeLists.txt writes it
# for each library.  A folder may include its own files, those of the folders that its libraries
# name, and of what these name; and no folder may name, by way of others, itself.

import pathlib
import re
import sys

SIM = pathlib.Path(__file__).resolve().parents[2] / "sim"
TOP = "sim"  # program.cpp and main.cpp, which may include all


def named(lines):
    """What the libraries of each folder name."""
    layers = {}
    for line in lines:
        folder, _, others = line.partition(":")
        layers.setdefault(folder, set()).update(o for o in others.strip().split(";") if o)
    return {folder: others - {folder} for folder, others in layers.items()}


def reachable(layers, folder):
    """Those that `folder` names, and what these name."""
    found, todo = set(), list(layers[folder])
    while todo:
        other = todo.pop()
        if other not in found:
            found.add(other)
            todo += layers.get(other, ())
    return found


def problems(layers):
    for folder in sorted(layers):
        below = reachable(layers, folder)
        if folder in below:
            yield f"sim/{folder} names itself, by way of others"
        for file in sorted((SIM / folder).rglob("*")):
            if file.suffix not in (".h", ".cpp"):
                continue
            for number, line in enumerate(file.read_text().splitlines(), 1):
                include = re.match(r'#include "sim/(?:([a-z]+)/)?', line)
                other = include and (include[1] or TOP)
                if other and other != folder and other not in below:
                    yield (f"{file.relative_to(SIM.parent)}:{number}: sim/{folder} does not name "
                           f"sim/{other} (DEPENDS in sim/{folder}/CMakeLists.txt)")


def main():
    layers = named(pathlib.Path(sys.argv[1]).read_text().splitlines())
    found = list(problems(layers))
    for problem in found:
        print(problem)
    return 1 if found or len(layers) < 20 else 0


if __name__ == "__main__":
    sys.exit(main())
