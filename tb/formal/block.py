"""block.py - a block as SMT2: terms of its states, and problems with no more of it than needed."""
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
        rtl = os.path.relpath(arguments.rtl, arguments.work)  # Yosys splits paths at blanks
        includes = " ".join(f"-I{rtl}/{folder}" for folder in ("regmap", "bus", "vga"))
        files = " ".join(os.path.relpath(source, arguments.work) for source in sources)
        script = (f"read_verilog {includes} {files}; hierarchy -check -top {self.name}; "
                  "proc -norom; flatten; memory_collect; opt_clean; write_smt2 -wires block.smt2; "
                  "write_json block.json")
        done = subprocess.run(["yosys", "-q", "-p", script], cwd=arguments.work, text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        if done.returncode:
            sys.exit(done.stdout)
        text = (arguments.work / "block.smt2").read_text()
        self.widths = {name: int(width) for name, width in
                       re.findall(r"^; yosys-smt2-wire (\S+) (\d+)$", text, re.M)}
        # Sorts of registers and inputs; of wires with their terms, each after those in its term.
        self.registers = dict(re.findall(
            r"^\(declare-fun \|(.+?)\| \(\|\w+\|\) (.+?)\)(?: ;.*)?$", text, re.M))
        self.wires = dict(re.findall(
            r"^\(define-fun \|(.+?)\| \(\(state \|\w+\|\)\) (.+?)\)(?: ;.*)?$", text, re.M))
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

    def edges_of(self, clock):
        return [edge for edge in self.edges if clock in self.clocks[edge.cell]]

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

    def rests(self, state):
        return f"(not {self.low('rest_o', state)})"

    def one_less(self, before, after):
        one = self.number(1, "rest_o")
        return f"(bvuge {self.at('rest_o', after)} (bvsub {self.at('rest_o', before)} {one}))"

    # ---- Problems ----

    def problem(self, steps, commands):
        """The commands, after the registers and wires that they reach, and those that these do.

        The steps say what registers became.  Those of a register that is not reached only give a
        value to a constant that nobody reads, so nothing becomes possible or impossible without
        them.  Functions of a state are constants with its name: z3 is slow with nested functions.
        """
        reached = {}
        new = symbols(commands)
        while new:
            name, state = new.pop()
            if name not in reached.setdefault(state, set()):
                reached[state].add(name)
                new |= symbols(told(self.wires[name], state) if name in self.wires else
                               steps.get(f"|{name} {state}|", ""))
        lines = []
        for state, names in sorted(reached.items()):
            for name, sort in self.registers.items():
                if name in names:
                    term = steps.get(f"|{name} {state}|")
                    lines.append(f"(define-fun |{name} {state}| () {sort} {term})" if term else
                                 f"(declare-const |{name} {state}| {sort})")
            lines += [f"(define-fun |{name} {state}| () {told(wire, state)})"
                      for name, wire in self.wires.items() if name in names]
        problem = "\n".join([*lines, commands, ""])
        # Without a memory in it z3 has a faster way.
        logic = "QF_AUFBV" if "(Array " in problem else "QF_BV"
        return f"(set-logic {logic})\n{problem}"


def told(term, state):
    """The term, of the state with this name."""
    return re.sub(r"\(\|([^|]+)\| state\)", rf"|\1 {state}|", term)


def symbols(text):
    """Names and states of the constants in it."""
    return set(re.findall(r"\|([^|]+) (s\d)\|", text))
