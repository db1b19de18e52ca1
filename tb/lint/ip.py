"""ip.py DIR - what the models of Intel's IP must have, beyond what Verilator checks.

A file is named as its module.  Each parameter is there in lower and in upper case, where the upper
one follows the lower one.  No net has a pull: with tri0 or tri1 in the instantiating module as
well, Verilator 5.006 silently holds the signal constant.  No parameter is a reserved word of VHDL,
since VHDL has a component of each model.  defaults.tsv names inputs that there are,
and gives all ones to each, as 1'b1 or as -1 to a vector.
"""
import pathlib
import re
import sys

VHDL_WORDS = set("""
    abs access after alias all and architecture array assert attribute begin block body buffer bus
    case component configuration constant disconnect downto else elsif end entity exit file for
    function generate generic group guarded if impure in inertial inout is label library linkage
    literal loop map mod nand new next nor not null of on open or others out package port postponed
    procedure process pure range record register reject rem report return rol ror select severity
    shared signal sla sll sra srl subtype then to transport type unaffected units until use
    variable wait when while with xnor xor assume context cover default fairness force parameter
    property protected release restrict sequence strong vmode vprop vunit""".split())


def without_comments(text):
    return re.sub(r"//.*", "", text)


def header(text):
    """Parameters and ports of the module in `text`."""
    return re.search(r"^module\s+(\w+)(.*?)\);", text, re.M | re.S)


def parameters(text, folder):
    found = re.search(r"#\((.*?)\n\)\s*\(", text, re.S)
    listed = found.group(1) if found else ""
    for name in re.findall(r'`include "(\w+\.vh)"', listed):
        listed += without_comments((folder / name).read_text())
    return dict(re.findall(r"(\w+)\s*=\s*([^,\s]+)", listed))


def problems(path):
    text = without_comments(path.read_text())
    module = header(text)
    if module.group(1) != path.stem:
        yield f"has module {module.group(1)}"
    pull = re.search(r"\b(tri0|tri1|pullup|pulldown)\b", text)
    if pull:
        yield f"has a {pull.group(0)}"
    if path.stem.startswith("de1sim_"):
        return
    given = parameters(text, path.parent)
    for name in given:
        lower, upper = name.lower(), name.upper()
        if lower not in given or given.get(upper) != lower:
            yield f"parameter {name}: expected {lower} = ..., {upper} = {lower}"
        if name in VHDL_WORDS:
            yield f"parameter {name} is a reserved word of VHDL"


def wrong_defaults(folder):
    rows = [line.split("\t") for line in (folder / "defaults.tsv").read_text().splitlines()]
    if rows[0] != ["module", "port", "default"]:
        yield "line 1, expected module, port, default"
    for number, (module, port, value) in enumerate(rows[1:], 2):
        text = header(without_comments((folder / f"{module}.v").read_text())).group(2)
        inputs = re.findall(r"input\s+wire\s*(\[.*?\])?\s*((?:\w+\s*,?\s*)+?)\s*"
                            r"(?=input|output|inout|$)", text)
        width = [vector for vector, names in inputs if port in re.split(r"[,\s]+", names)]
        if not width:
            yield f"line {number}: {module} has no input {port}"
        elif value != ("-1" if width[0] else "1'b1"):
            yield f"line {number}: {module}'s {port} has {value}"


def main():
    folder = pathlib.Path(sys.argv[1])
    files = sorted(folder.glob("*.v"))
    found = [f"{path.name} {what}" for path in files for what in problems(path)]
    found += [f"defaults.tsv {what}" for what in wrong_defaults(folder)]
    for line in found:
        print(line)
    return 1 if found or not files else 0


sys.exit(main())
