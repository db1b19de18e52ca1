"""random_loops.py DE1SIM GCC EXAMPLES FOLDER - programs of random loops, with the shortcut for
loops and without it: everything that a run tells must be the same.

Each program has a few loops that wait for KEY, SW, PS/2, a JTAG UART, timers, memory that an
interrupt handler writes, the audio FIFOs or a frame's end, or that count; hands act at random times
meanwhile.  What the loops decide goes to the lamps and to the JTAG UART, with its time.

RANDOM_LOOPS=1000 is the least number of loops, RANDOM_LOOPS_SEED=7 another seed.  A difference is
reported with the seed of its program, which is then in FOLDER.
"""
import json
import os
import random
import shutil
import subprocess
import sys

PROLOGUE = r"""
#include "processor.h"
#define TIMER ((volatile uint32_t*)0xFF202000)
#define HPS_TIMER ((volatile uint32_t*)0xFFC08000)
static volatile unsigned ticks, memory, other[4];
static unsigned sum;
void __attribute__((interrupt("IRQ"), target("arm"))) on_irq(void) {
    const unsigned id = ICCIAR & 0x3FF;
    if (id == 72) TIMER[0] = 0;
    ++ticks;
    ICCEOIR = id;
}
static void start_timer(unsigned clocks, unsigned interrupts) {
    TIMER[1] = 8;
    TIMER[0] = 0;
    TIMER[2] = clocks & 0xFFFF;
    TIMER[3] = clocks >> 16;
    TIMER[1] = 6 | interrupts;
}
static unsigned long long then;
static unsigned long long global_time(void) {
    unsigned low, high;
    do {
        high = REGISTER(0xFFFEC204);
        low = REGISTER(0xFFFEC200);
    } while (high != REGISTER(0xFFFEC204));
    return (unsigned long long)high << 32 | low;
}
static unsigned cycles(void) {
    unsigned value;
    asm volatile("mrc p15, 0, %0, c9, c13, 0" : "=r"(value));
    return value;
}
static unsigned __attribute__((noinline)) ticks_now(void) { return ticks; }
// Samples, as many as there is room for; whether there was none.
static int play(int most) {
    int n = 0;
    for (; n < most && AUDIO_FIFOSPACE >> 24; n++) AUDIO_LEFTDATA = AUDIO_RIGHTDATA = n << 20;
    return n == 0;
}
static unsigned __attribute__((noinline)) key(void) { return KEY_DATA & 15; }
static void tell(unsigned value) {
    sum = sum * 31 + value;
    LEDR_DATA = sum & 0x3FF;
    HEX3_0_DATA = sum;
    for (int digit = 28; digit >= 0; digit -= 4) {
        for (int left = 10000; JTAG_UART0_CONTROL >> 16 == 0 && left; --left) continue;
        JTAG_UART0_DATA = "0123456789ABCDEF"[value >> digit & 15];
    }
    JTAG_UART0_DATA = '\n';
}
int main(void) {
    unsigned n = 0, x = 0;
    ICDISER(72) = 1u << 72 % 32;
    ICDIPTR(72) = 1;
    ICCPMR = 0xFF;
    ICCICR = 1;
    ICDDCR = 1;
    A9_TIMER_LOAD = 12345;
    A9_TIMER_CONTROL = 3;
    REGISTER(0xFFFEC200) = 0xFFFFF000;
    REGISTER(0xFFFEC208) = 1;
    asm volatile("mcr p15, 0, %0, c9, c12, 0" : : "r"(5));
    asm volatile("mcr p15, 0, %0, c9, c12, 1" : : "r"(1u << 31));
    HPS_TIMER[0] = 4321;
    HPS_TIMER[2] = 3;
    asm volatile("cpsie i");
"""


def conditions(chance):
    """What a loop waits for, each with what comes before it."""
    clocks = chance.randrange(300, 100000)
    bit = 1 << chance.randrange(4)
    return [
        ("", f"(KEY_DATA & {bit}) == 0"), ("", f"(KEY_DATA & {bit}) != 0"), ("", "key() == 0"),
        ("x = KEY_DATA;", "KEY_DATA == x"), ("x = SW_DATA;", "SW_DATA == x"),
        ("KEY_EDGE = 15;", "KEY_EDGE == 0"),
        ("", "!(PS2_0_DATA & 0x8000)"), ("", "!(JTAG_UART0_DATA & 0x8000)"),
        ("", "!(PS2_0_CONTROL & 0x100)"), ("", "JTAG_UART0_CONTROL >> 16 < 60"),
        (f"start_timer({clocks}, 0);", "!(TIMER[0] & 1)"),
        (f"start_timer({clocks}, 1); x = ticks + 2;", "ticks < x"),
        (f"start_timer({clocks}, 1); x = ticks + 1;", "ticks_now() != x"),
        ("A9_TIMER_STATUS = 1;", "!A9_TIMER_STATUS"),
        ("", f"REGISTER(0xFFFEC604) > {chance.randrange(200, 12000)}"),
        (f"x = REGISTER(0xFFFEC200) + {chance.randrange(100, 50000)};",
         "(int)(REGISTER(0xFFFEC200) - x) < 0"),
        ("x = REGISTER(0xFFFEC200);", f"REGISTER(0xFFFEC200) - x < {chance.randrange(200000)}"),
        ("then = global_time();", f"global_time() - then < {chance.randrange(200000)}"),
        ("x = HPS_TIMER[1];", f"x - HPS_TIMER[1] < {chance.randrange(4000)}"),
        ("x = cycles();", f"cycles() - x < {chance.randrange(500000)}"),
        (f"x = cycles() + {chance.randrange(500000)};", "(int)(cycles() - x) < 0 && KEY_DATA == 0"),
        ("", f"(REGISTER(0xFFFEC200) & {chance.randrange(256)}) != 0"),
        ("(void)HPS_TIMER[3];", "!HPS_TIMER[4]"),
        ("PIXEL_BUFFER = 1;", "PIXEL_STATUS & 1"),
        ("x = AUDIO_FIFOSPACE;", "AUDIO_FIFOSPACE == x"),
        ("play(150);", "play(1)"),
    ]


def bodies(chance):
    """What it does meanwhile."""
    return ["", "", "", "++n;", "++memory;", "LEDR_DATA = sum & 0x3FF;", "x ^= 0;", "n += 3;",
            "other[1] = n;", "(void)SW_DATA;", "play(1);",
            "HEX3_0_DATA = sum; (void)KEY_DATA;", "n = key();",
            f"if (++n == {chance.randrange(50, 5000)}) LEDR_DATA = 0x2AA;",
            f"for (volatile int i = 0; i < {chance.randrange(3, 60)}; i++) continue;"]


def loop(chance):
    before, condition = chance.choice(conditions(chance))
    body = chance.choice(bodies(chance))
    most = chance.choice([chance.randrange(5, 100), chance.randrange(100, 20000)])
    kind = chance.randrange(6)
    if kind == 0:  # a delay
        count = chance.randrange(100, 400000)
        return chance.choice([
            f"for (volatile int i = 0; i < {count}; i++) continue;",
            f"for (int i = {count}; i > 0; i--) asm volatile(\"\");",
            f"for (volatile unsigned i = {count}; i; i -= 1) memory += 2;",
            f"for (int j = 0; j < 20; j++) for (volatile int i = 0; i < {count // 20}; i++);"])
    if kind == 1:  # the same register twice in a round
        return (f"for (int i = 0; i < {most}; i++) {{ x = KEY_DATA; while (KEY_DATA) ++n; "
                "if (x) { tell(x); break; } }")
    if kind == 2:
        return f"{before} for (n = 0; n < {most} && {condition}; n++) {{ {body} }}"
    if kind == 3:
        return f"{before} do {{ {body} }} while ({condition}); ++n;"
    return f"{before} while ({condition}) {{ {body} }}"


def program(chance, loops):
    return PROLOGUE + "".join(f"    n = 0;\n    {loop(chance)}\n    tell(n);\n"
                              for _ in range(loops)) + \
        "    for (;;) LEDR_DATA = SW_DATA | sum;\n}\n"


def scenario(chance):
    steps, held = [], set()
    for _ in range(chance.randrange(6, 16)):
        wait, switch = chance.randrange(2, 900), chance.randrange(10)
        steps.append(chance.choice([
            f"delay: {wait}us", f"delay: {wait}us", f"delay: {wait * 1000 + 137}ns",
            f"press: {{key: {chance.randrange(4)}, for: {chance.randrange(1, 600)}us}}",
            f"press: {{key: {chance.randrange(4)}, for: {chance.randrange(1, 600)}us}}",
            f"{'release' if switch in held else 'hold'}: {{switch: {switch}}}",
            'type-serial: "ab\\n"', "type-keys: k"]))
        if "switch" in steps[-1]:
            held ^= {switch}
    return "name: random\nversion: 1\nsteps:\n" + "".join(f"  - {step}\n" for step in steps)


def told(de1sim, folder, duration, options):
    """All that a run tells, but for what it cost."""
    out = os.path.join(folder, "out")
    shutil.rmtree(out, ignore_errors=True)
    ran = subprocess.run([de1sim, "run", "random.yaml", "--elf", "random.elf", "--quiet",
                          "--frames", "none", "--duration", duration, "--out", "out"] + options,
                         cwd=folder, capture_output=True, text=True, timeout=600)
    with open(os.path.join(out, "report.json"), encoding="utf-8") as file:
        report = json.load(file)
    report.pop("wall")
    files = []
    for name in ("console.txt", "audio.wav"):
        with open(os.path.join(out, name), "rb") as file:
            files.append(file.read())
    return ran.returncode, report, files


def difference(one, other, name="report"):
    if isinstance(one, dict) and isinstance(other, dict):
        for key in sorted(set(one) | set(other)):
            found = difference(one.get(key), other.get(key), f"{name}.{key}")
            if found:
                return found
        return None
    return None if one == other else f"{name}: {str(one)[:200]} or {str(other)[:200]}"


def main():
    de1sim, gcc, examples, folder = sys.argv[1:5]
    least = int(os.environ.get("RANDOM_LOOPS", "24"))
    first = int(os.environ.get("RANDOM_LOOPS_SEED", "1"))
    os.makedirs(folder, exist_ok=True)
    loops = seed = instructions = 0
    while loops < least:
        chance = random.Random(f"{first} {seed}")
        count = chance.randrange(3, 7)
        with open(os.path.join(folder, "random.c"), "w", encoding="utf-8") as file:
            file.write(program(chance, count))
        with open(os.path.join(folder, "random.yaml"), "w", encoding="utf-8") as file:
            file.write(scenario(chance))
        flags = [chance.choice(["-O0", "-O1", "-O1", "-O2", "-Os"]),
                 chance.choice(["-marm", "-mthumb"])]
        subprocess.run([gcc, *flags, "-mcpu=cortex-a9", "-mfpu=neon", "-mfloat-abi=softfp",
                        "-mgeneral-regs-only", "-nostartfiles", f"-I{examples}", "-w",
                        f"-T{examples}/program.ld", f"{examples}/start.S", "random.c", "-o",
                        "random.elf"], cwd=folder, check=True)
        more = ["--cpi", chance.choice(["1", "1", "2", "1.3"])]
        duration = chance.choice(["9ms", "9ms", "9ms", "52ms"])  # in that, frames end
        results = [told(de1sim, folder, duration, more + extra)
                   for extra in ([], ["--no-shortcuts"])]
        found = difference(results[0][1], results[1][1])
        if results[0][0] != results[1][0]:
            found = f"exit codes: {results[0][0]} or {results[1][0]}"
        if results[0][2] != results[1][2]:
            found = found or "console.txt or audio.wav"
        if found:
            sys.exit(f"with the shortcut, or without: {found}\nRANDOM_LOOPS_SEED={first}, program "
                     f"{seed} ({' '.join(flags + more)}), is in {folder}")
        instructions += results[0][1]["program"]["instructions"]
        loops += count
        seed += 1
    print(f"{loops} loops in {seed} programs: {instructions} instructions, all the same")


if __name__ == "__main__":
    main()
