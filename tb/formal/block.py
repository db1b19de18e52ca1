"""block.py - a block as SMT2: terms of its states, and problems with no more of it than needed.

Files of sim/fpga that read each other by their places in fpga.v (sim/fpga/inside.v) are connected
where both places are in the block; what they read of outside may be anything.
"""
import collections
import json
import os
import re
import subprocess
import sys

Edge = collections.namedtuple("Edge", "cell signal register term")


class Block:
    def __init__(self, arguments, sources):
        self.name = sources[0].stem
        inside = "".join(s.read_text() for s in sources if s.stem == "inside")
        sources = [without_places(source, arguments.work) for source in sources]
        rtl = os.path.relpath(arguments.rtl, arguments.work)  # Yosys splits paths at blanks
        includes = " ".join(f"-I{rtl}/{folder}" for folder in ("regmap", "bus", "vga"))
        files = " ".join(os.path.relpath(source, arguments.work) for source in sources)
        script = (f"read_verilog {includes} {files}; hierarchy -check -top {self.name}; "
                  f"proc -norom; flatten; {connections(self.name, sources, inside)}; "
                  "memory_collect; opt_clean; write_smt2 -wires block.smt2; write_json block.json")
        done = subprocess.run(["yosys", "-q", "-p", script], cwd=arguments.work, text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        if done.returncode:
            sys.exit(done.stdout)
        text = (arguments.work / "block.smt2").read_text()
        self.widths = {name: int(width) for name, width in
                       re.findall(r"^; yosys-smt2-wire (\S+) (\d+)$", text, re.M)}
        # First registers and inputs, then wires, each after those in its term.
        sort = r"(Bool|\(_ BitVec \d+\)|\(Array .+?\)\))"
        self.sorts = dict(re.findall(
            rf"^\(declare-fun \|(.+?)\| \(\|\w+\|\) {sort}\)", text, re.M))
        wires = re.findall(
            rf"^\(define-fun \|(.+?)\| \(\(state \|\w+\|\)\) {sort} (.+?)\)(?: ;.*)?$", text, re.M)
        self.sorts.update((name, sort) for name, sort, _ in wires)
        self.wires = {name: term for name, _, term in wires}
        self.edges = [Edge(cell, signal, register, term)
                      for term, register, cell, signal in re.findall(
                          r"^  \(= (.+) \(\|([^|]+)\| next_state\)\) ; (\S+) ?(.*)$", text, re.M)]
        netlist = json.loads((arguments.work / "block.json").read_text())["modules"][self.name]
        nets = {}
        for net, bits in netlist["netnames"].items():
            nets.setdefault(bits["bits"][0], set()).add(net)
        # The names of its clock, for each cell that has one.
        self.clocks = {name.replace("\\", "/"): nets[cell["connections"][port][0]]
                       for name, cell in netlist["cells"].items()
                       for port in ("CLK", "WR_CLK") if port in cell["connections"]}
        # Registers on another clock, which may tick at any time.
        self.foreign = self.edges_of("clk_audio_i") + self.edges_of("clk_td_i")
        self.edges = [edge for edge in self.edges if edge not in self.foreign]

    def edges_of(self, clock, edges=None):
        return [edge for edge in (self.edges if edges is None else edges)
                if clock in self.clocks[edge.cell]]

    # ---- What registers become: terms by the register's symbol ----

    def clock(self, before, after, edges=None):
        """The state after is the state before plus one clock, in all or some registers."""
        return {f"|{edge.register} {after}|": told(edge.term, before)
                for edge in (self.edges if edges is None else edges)}

    @staticmethod
    def kept(before, after, edges):
        """The state after is the state before: there was no clock."""
        return {f"|{edge.register} {after}|": f"|{edge.register} {before}|" for edge in edges}

    # ---- Terms ----

    def stands(self, state, edges=None):
        """A clock would not change the state."""
        same = (f"(= {register} {term})"
                for register, term in self.clock(state, state, edges).items())
        return f"(and true {' '.join(same)})"

    def at(self, signal, state):
        return f"|{self.name}_n {signal} {state}|"

    def low(self, signal, state):
        if self.widths[signal] == 1:
            return f"(not {self.at(signal, state)})"
        return f"(= {self.at(signal, state)} {self.number(0, signal)})"

    def same(self, signal, before, after, more=0):
        number = self.at(signal, before)
        if more:
            number = f"(bvadd {number} {self.number(more, signal)})"
        return f"(= {self.at(signal, after)} {number})"

    def number(self, value, signal):
        return f"(_ bv{value} {self.widths[signal]})"

    def named(self, name):
        """The signals of that name in the block and its parts."""
        return sorted(one for one in self.widths if one.split(".")[-1] == name)

    def rests(self, rest, state):
        return f"(not {self.low(rest, state)})"

    def one_less(self, rest, before, after):
        one = self.number(1, rest)
        return f"(bvuge {self.at(rest, after)} (bvsub {self.at(rest, before)} {one}))"

    # ---- Problems ----

    def problem(self, steps, formula, seen=()):
        """Asks whether the formula can be true, and if so which values the `seen` signals have.

        The steps say what registers became.  Those of a register that is not reached only give a
        value to a name that nobody reads, so nothing becomes possible or impossible without them.
        A term has its name by `let`, after those in it: z3 reads functions 50 times more slowly.
        """
        formula = f"(and {formula} {' '.join(f'(= {shown(signal)} {signal})' for signal in seen)})"
        reached = {}
        new = symbols(formula)
        while new:
            name, state = new.pop()
            if name not in reached.setdefault(state, set()):
                reached[state].add(name)
                new |= symbols(self.term(name, state, steps) or "")
        known, terms = [], []
        for state, names in sorted(reached.items()):
            for name in (name for name in self.sorts if name in names):
                term = self.term(name, state, steps)
                if term:
                    terms.append(f"(let ((|{name} {state}| {term}))")
                else:
                    known.append(f"(declare-const |{name} {state}| {self.sorts[name]})")
        known += [f"(declare-const {shown(signal)} {self.sorts[name]})"
                  for signal in seen for name, _ in symbols(signal)]
        lines = [*known, "(assert", *terms, formula, ")" * len(terms) + ")", "(check-sat)"]
        if seen:
            lines.append(f"(get-value ({' '.join(map(shown, seen))}))")
        # Without a memory in it z3 has a faster way.
        logic = "QF_AUFBV" if any("(Array " in line for line in known) else "QF_BV"
        return "\n".join([f"(set-logic {logic})", *lines, ""])

    def term(self, name, state, steps):
        """None: the register or input may have any value."""
        return told(self.wires[name], state) if name in self.wires else \
            steps.get(f"|{name} {state}|")


# Where a block of which something is proved lies in fpga.v, if it reads places of its own.
PLACES = {"fpga": "", "vga": "video_block.vga_block."}
INSTANCE = re.compile(r"^ +(\w+) (?:#\([^;]*?\) )?(\w+) \(", re.M)
MODULE = re.compile(r"^module (\w+).*?^endmodule", re.M | re.S)
PLACE = re.compile(r"^ *assign (\w+) += fpga\.([\w.]+);$", re.M)


def without_places(source, work):
    """The source, or a copy whose outputs by places may be anything until they are connected."""
    text = source.read_text()
    bare = PLACE.sub(lambda line: f"    assign {line[1]} = from_{line[1]};", text)
    for module in MODULE.finditer(text):
        for port in PLACE.findall(module[0]):
            width = re.search(rf"output wire +(\[\d+:0\])? *{port[0]}\b", module[0])[1] or ""
            bare = re.sub(rf"^(    assign {port[0]} = from_{port[0]};)",
                          rf"    wire {width} from_{port[0]};\n\1", bare, flags=re.M)
    # What fabric.cpp drives may be anything.
    bare = re.sub(r"^    reg( +\[\d+:0\] +\w+ +/\* verilator public_flat_rw)",
                  r"    (* anyseq, keep *) reg\1", bare, flags=re.M)
    # Nobody reads these in a block alone.
    bare = re.sub(r"^    (wire|reg)( +(?:\[\d+:0\])? *(?:due|rest|now)\b)",
                  r"    (* keep *) \1\2", bare, flags=re.M)
    if bare == text:
        return source
    copy = work / source.name
    copy.write_text(bare)
    return copy


def instances(inner, name, place):
    """Module and place of whatever is in the module `name`; `inner` has modules' instances."""
    for module, instance in inner.get(name, ()):
        yield module, place + instance
        yield from instances(inner, module, place + instance + ".")


def sources_of(block, rtl):
    """The files of a block and of what is in it: the simulation's own where it has one."""
    formal, sim = rtl / "../tb/formal", rtl / "../sim/fpga"
    text, file_of = {}, {}
    for file in [*rtl.glob("*.v"), *rtl.glob("*/*.v"), *sim.glob("*.v"), formal / "root_clock.v"]:
        if file.parent.name != "ip":
            text[file] = file.read_text()
            file_of.update((module[1], file) for module in MODULE.finditer(text[file]))
    files, names = [], [block]
    for name in names:
        file = file_of.get(name)
        if file and file not in files:
            files.append(file)
            names += [module for module, _ in INSTANCE.findall(text[file])]
    return files


def connections(name, sources, inside):
    """Commands of Yosys that connect what is read by places, in the flat block."""
    place = PLACES.get(name)
    commands = []
    if inside and place is not None:
        inner = {source.stem: INSTANCE.findall(source.read_text()) for source in sources}
        places = list(instances(inner, name, place))
        for module in MODULE.finditer(inside):
            readers = [at for of, at in places if of == module[1]]
            for port, source in PLACE.findall(module[0]):
                for reader in readers:
                    if source.startswith(place):
                        commands.append(f"connect -nounset -set {reader[len(place):]}.from_{port} "
                                        f"{source[len(place):]}")
    return "; ".join([f"cd {name}", *commands, "cd ..", "setundef -undriven -anyseq"])


def shown(signal):
    """The name of a constant that has the signal's value."""
    return f"{signal[:-1]} shown|"


def told(term, state):
    """The term, of the state with this name."""
    return re.sub(r"\(\|([^|]+)\| state\)", rf"|\1 {state}|", term)


def symbols(text):
    """Names and states of the constants in it."""
    return set(re.findall(r"\|([^|]+) (s\d)\|", text))
