"""sleep.py - proves with Yosys and z3 that a block which sleeps would not have changed.

What awake_o, due and rest promise is in rtl/SLEEP.md.

sleep.py --rtl DIR --work DIR BLOCK [--strobes PORT...] [--pins PORT...] [--list]

With --list the names of the files that it reads.

It is proved from any state, reachable or not, after any clock
before it, a reset too:

    sleeps       not awake, not due, no strobe, pins as in the clock before: the next clock leaves
                 every register and every word of memory as it is
    stays        and awake_o stays 0
    rests        with rest = r > 0 the clock after that is not due either, and has r - 1 to come

    decoder sleeps   of video_in.v: with td_awake_o = 0, and no reset there, the decoder's clock
                 leaves its registers as they are

Any other input, such as an address, data or the time, may do what it likes, and so may registers
of the audio clock and the video decoder's, which do not tick in `stays` and `rests`.  Of vga.v,
whose clock never stops, `rests` says that in the r clocks after this one nothing changes and
nobody is spoken to; of fpga_clocks.v, `leaps`, that a leap over n + 1 clocks is one over n and a
clock.  Of fpga.v with the simulation's files, `sleeps` is said of each group, and `rests` of all
together.

0 if all of it holds.  Where it does not, counterexample.txt in the work folder has a line per
signal, and a column per clock.
"""
import argparse
import collections
import os
import pathlib
import re
import subprocess
import sys

from block import Block, shown, sources_of, symbols


# A claim: what registers became (block.py), what was so besides, and what follows from them.
Claim = collections.namedtuple("Claim", "name steps premises conclusions")


def sleep(block, strobes, pins):
    """What holds of a block with awake_o."""
    def quiet(state, before):
        return [*(block.low(name, state) for name in strobes),
                *(block.same(name, before, state) for name in pins),
                *(block.low(name, state) for name in ("rst_i",) if name in block.widths)]

    asleep = [*quiet("s1", "s0"), block.low("awake_o", "s1"),
              *(block.low(name, "s1") for name in block.named("due"))]
    later = [*asleep, *quiet("s2", "s1")]
    clock = block.clock("s0", "s1")
    clocks = {**clock, **block.clock("s1", "s2")}
    home_clocks = {**clocks, **block.kept("s1", "s2", block.foreign)}
    yield Claim("sleeps", clock, asleep, [block.stands("s1")])
    yield Claim("stays", home_clocks, later, [block.low("awake_o", "s2")])
    if "td_awake_o" in block.widths:
        decoders = block.edges_of("clk_td_i", block.foreign)
        yield Claim("decoder sleeps", {**clock, **block.clock("s0", "s1", decoders)},
                    [block.low("td_awake_o", "s1"), block.low("rst_td_i", "s1")],
                    [block.stands("s1", decoders)])
    for due, rest, now in zip(*map(block.named, ("due", "rest", "now"))):
        yield Claim("rests", home_clocks,
                    [*later, block.rests(rest, "s1"), block.same(now, "s1", "s2", 1)],
                    [block.low(due, "s2"), block.one_less(rest, "s1", "s2")])


def framed(block, state, beam=""):
    """The invariant of vga.v that its rest_o needs."""
    h, v, cell, shown, text, flat, half, pixel, word = (
        block.at(beam + name, state) for name in ("h", "v", "cell_o", "shown", "text_q", "flat_q",
                                                  "half_q", "pixel_q", "word_i"))
    return [f"(and (bvult {h} (_ bv800 10)) (bvult {v} (_ bv525 10)))",
            f"(=> {cell} (and {shown} {text} (= ((_ extract 2 0) {h}) #b001)))",
            f"(=> {flat} (and (not {text}) (bvule #b{34:010b} {h}) (bvule {h} #b{641:010b})"
            f" (bvult {v} (_ bv480 10))"
            f" (= {pixel} (ite {half} ((_ extract 31 16) {word}) ((_ extract 15 0) {word})))))"]


def beam(block):
    """What holds of vga.v.  As line_buffer.v has it, a row does not begin with a flat block, and a
    word that was read stays until another is."""
    clock = block.clock("s0", "s1")
    now = block.same("timing.now", "s0", "s1", 1)
    reset = [block.at("rst_i", "s0"), now]
    ticks = [block.low("rst_i", "s0"), *framed(block, "s0"), now,
             f"(not (and {block.at('flat_i', 's0')}"
             f" (= ((_ extract 7 3) {block.at('index_o', 's0')}) #b00000)))",
             f"(or {block.at('pixel_o', 's0')} {block.same('word_i', 's0', 's1')})"]
    yield Claim("framed by a reset", clock, reset, framed(block, "s1"))
    yield Claim("framed", clock, ticks, framed(block, "s1"))
    yield Claim("rests", clock, [*ticks, block.low("rst_i", "s1"), block.rests("rest", "s0")],
                [block.stands("s1"), block.one_less("rest", "s0", "s1"),
                 *(block.low(name, "s1") for name in ("pixel_o", "line_end_o", "frame_end_o",
                                                      "cell_o"))])


def fabric(block, strobes, pins):
    """What holds of fpga.v, whose registers without a group are the beam's and the time."""
    groups = tuple(f"clocks.{name}_group" for name in ("lw", "h2f", "memory", "ports", "audio"))
    ours = {group: block.edges_of(f"{group}.clk_o") for group in groups}
    grouped = sum(ours.values(), [])
    others = [edge for edge in block.edges if edge not in grouped]
    timeless = [edge for edge in others if edge.signal != r"\clocks.now"]

    def unmoved(name, state):
        bit = 0 if name.startswith("lw_") else 1 if name.startswith("h2f_") else 2
        return f"(= ((_ extract {bit} {bit}) {block.at('clocks.moved', state)}) #b0)"

    told = [f"(=> {block.at('rst_i', 's1')} (= {block.at('clocks.moved', 's1')} #b111))",
            *(f"(=> {unmoved(name, 's1')} {block.low(name, 's1')})" for name in strobes),
            *(f"(=> {unmoved(name, 's1')} {block.same(name, 's0', 's1')})" for name in pins)]
    for group in groups:
        yield Claim(f"{group} sleeps", block.clock("s0", "s1"),
                    [*told, block.low(f"{group}.awake_i", "s1")],
                    [block.stands("s1", ours[group])])
    # The clock for which the picture's fetch has waited is a clock of its group alone.
    memory = ours["clocks.memory_group"]
    still = [edge for edge in grouped if edge not in memory]
    waits = block.low("clocks.memory_group.awake_i", "s0")
    fetched = block.clock("s0", "s1", memory)
    fetches = {register: f"(ite {waits} {before} {fetched[register]})"
               for register, before in block.kept("s0", "s1", memory).items()}
    yield Claim("rests",
                {**block.clock("s0", "s1", others), **fetches,
                 **block.kept("s0", "s1", still + block.foreign)},
                [*framed(block, "s0", "video_block.vga_block."), block.low("clocks.skip", "s0"),
                 *(block.low(name, state) for name in ("clocks.moved", "rst_i")
                   for state in ("s0", "s1")), block.rests("clocks.rest", "s0")],
                [block.stands("s1", timeless), block.one_less("clocks.rest", "s0", "s1"),
                 *(block.low(f"{group}.awake_i", "s1") for group in groups)])


def leap(block):
    """What holds of fpga_clocks.v: s0 skips to s1; s2, at the same time, skips one less, to s3."""
    yield Claim("leaps", {**block.clock("s0", "s1"), **block.clock("s2", "s3"),
                          **block.clock("s3", "s4")},
                [block.same("now", "s0", "s2"), block.same("skip", "s2", "s0", 1),
                 f"(not {block.low('skip', 's0')})", block.low("skip", "s3")],
                [block.same("now", "s1", "s4")])


def ask(problem, work):
    (work / "problem.smt2").write_text(problem)
    return subprocess.run(["z3", work / "problem.smt2"], stdout=subprocess.PIPE, text=True).stdout


def holds(block, claim, work):
    """Whether the claim holds: its premises are satisfiable, but not without a conclusion.

    Each conclusion is asked for by itself: it reaches less of the block than all of them.  If one
    does not hold, counterexample.txt says why.
    """
    given = f"(and {' '.join(claim.premises)})"
    for conclusion in sorted(claim.conclusions, key=len):  # the quick ones first
        broken = f"(and {given} (not {conclusion}))"
        answer = ask(block.problem(claim.steps, broken), work)
        if answer == "unsat\n":
            continue
        if answer != "sat\n":
            sys.exit(answer)
        tell(block, claim, broken, work)
        return False
    if ask(block.problem(claim.steps, given), work) != "sat\n":
        sys.exit(f"{claim.name}: this never is the case")
    return True


def tell(block, claim, broken, work):
    known = " ".join([*claim.steps, *claim.steps.values(), broken])
    states = sorted({state for _, state in symbols(known)})
    signals = [block.at(name, state) for name in block.widths for state in states]
    answer = ask(block.problem(claim.steps, broken, signals), work)
    values = dict(re.findall(r"(\|.+?\|) (\S+?)\)+\n", answer))
    (work / "counterexample.txt").write_text("".join(
        f"{name:40} {' '.join(values[shown(block.at(name, state))] for state in states)}\n"
        for name in block.widths))


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--rtl", type=pathlib.Path, required=True)
    parser.add_argument("--work", type=pathlib.Path, required=True)
    parser.add_argument("--strobes", nargs="*", default=[])
    parser.add_argument("--pins", nargs="*", default=[])
    parser.add_argument("--list", action="store_true")
    parser.add_argument("block")
    arguments = parser.parse_args()
    sources = sources_of(arguments.block, arguments.rtl)
    if arguments.list:
        print("\n".join(os.path.relpath(source, arguments.rtl) for source in sources))
        return
    arguments.work.mkdir(parents=True, exist_ok=True)
    block = Block(arguments, sources)
    if block.name == "vga":
        claims = beam(block)
    elif block.name == "fpga_clocks":
        claims = leap(block)
    else:
        claims = (fabric if block.name == "fpga" else sleep)(block, arguments.strobes,
                                                             arguments.pins)
    failed = next((claim.name for claim in claims if not holds(block, claim, arguments.work)), None)
    if failed:
        sys.exit(f"{failed}: does not hold, see {arguments.work}/counterexample.txt")


if __name__ == "__main__":
    main()
