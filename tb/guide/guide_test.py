"""guide_test.py README BIN EXAMPLES FOLDER [SOURCE] - does what a chapter of the guide says.

All blocks ```sh of README run in order, in one bash, in the empty FOLDER; BIN is in front of PATH.
What is not there in a test is put in its place: EXAMPLES for /usr/share/de1sim/examples, this
project's rtl/ for /usr/share/de1sim/rtl, and a port that is free for 3333.  With SOURCE, FOLDER
holds a copy of the project, as a clone would.

A block ```text that comes next is what the commands print.  There "..." is any text within a line,
and alone on a line any number of lines.  Exit code 1 and the difference if something else was
printed, or if a command failed; 77 where bwrap cannot confine hand-ins, with its reason.  Other
kinds of block are for the reader alone.
"""
import argparse
import difflib
import os
import pathlib
import re
import shlex
import shutil
import socket
import subprocess
import sys

PARTS = ["CMakeLists.txt", "CMakePresets.json", "Makefile", "LICENSE", "CHANGELOG.md", ".ci", "rtl",
         "sim", "sw", "tb"]
INSTALLED = "/usr/share/de1sim/examples"
INSTALLED_RTL = "/usr/share/de1sim/rtl"
RTL = pathlib.Path(__file__).resolve().parents[2] / "rtl"
PORT = "3333"
MARK = "@@ block {} @@"


def blocks(text):
    """The commands and the expected text, or None, of each block ```sh."""
    fences = re.findall(r"^```(\w*)\n(.*?)^```$", text, re.M | re.S)
    for (kind, body), (next_kind, next_body) in zip(fences, fences[1:] + [("", "")]):
        if kind == "sh":
            yield body, next_body if next_kind == "text" else None


def matches(expected, actual):
    pattern = ""
    for line in expected.splitlines():
        if line.strip() == "...":
            pattern += r"(?:.*\n)*?"
        else:
            pattern += ".*?".join(map(re.escape, line.rstrip().split("..."))) + " *\n"
    return re.fullmatch(pattern, actual) is not None


def free_port():
    with socket.socket() as listener:
        listener.bind(("127.0.0.1", 0))
        return str(listener.getsockname()[1])


def run(chapter, arguments):
    """The exit code, and what each block printed, up to the one that failed."""
    script = "set -e -o pipefail\n"
    port, examples = free_port(), shlex.quote(str(arguments.examples.resolve()))
    for number, (commands, _) in enumerate(chapter):
        script += f"echo; echo '{MARK.format(number)}'\n"
        commands = commands.replace(INSTALLED_RTL, shlex.quote(str(RTL)))
        script += commands.replace(INSTALLED, examples).replace(PORT, port)
    path = f"{arguments.bin.resolve()}:{os.environ['PATH']}"
    environment = dict(os.environ, PATH=path, LC_ALL="C")
    for name in ["MAKEFLAGS", "MAKELEVEL", "MFLAGS"]:  # of `make test`
        environment.pop(name, None)
    done = subprocess.run(["bash", "-c", script], cwd=arguments.folder, env=environment,
                          stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, text=True, check=False)
    printed = done.stdout.replace(port, PORT)
    return done.returncode, re.split(r"\n@@ block \d+ @@\n", "\n" + printed)[1:]


def main():
    parser = argparse.ArgumentParser()
    for name in ["readme", "bin", "examples", "folder"]:
        parser.add_argument(name, type=pathlib.Path)
    parser.add_argument("source", type=pathlib.Path, nargs="?")
    arguments = parser.parse_args()

    shutil.rmtree(arguments.folder, ignore_errors=True)
    arguments.folder.mkdir(parents=True)
    if arguments.source:
        for part in PARTS:
            path = arguments.source / part
            if path.is_dir():
                shutil.copytree(path, arguments.folder / part)
            elif path.exists():
                shutil.copy(path, arguments.folder)

    chapter = list(blocks(arguments.readme.read_text()))
    code, outputs = run(chapter, arguments)
    cannot = re.search(r"^.* bwrap, which cannot do it here: .*$", "\n".join(outputs), re.M)
    if cannot:
        print(cannot[0])
        return 77
    wrong = 0
    for (commands, expected), actual in zip(chapter, outputs):
        actual = actual and actual.rstrip("\n") + "\n"
        if expected is None or matches(expected, actual):
            continue
        wrong += 1
        print(f"{arguments.readme}: after\n{commands}")
        sys.stdout.writelines(difflib.unified_diff(
            expected.splitlines(True), actual.splitlines(True), "as the guide says", "as it is"))
    if code != 0 and outputs:
        failed = chapter[len(outputs) - 1][0]
        print(f"{arguments.readme}: exit code {code} in\n{failed}{outputs[-1]}")
    print(f"{arguments.readme}: {len(chapter)} blocks, {len(outputs)} run, {wrong} wrong")
    return 1 if code or wrong or not chapter else 0


sys.exit(main())
