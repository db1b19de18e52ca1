"""waiting_programs.py DE1SIM GCC EXAMPLES FOLDER - how fast programs run that wait or count.

Prints the factor of real time of each, by processor time: of a run of RUN_S less one of a tenth of
it.  Then the least and the median.
"""
import json
import os
import resource
import statistics
import subprocess
import sys

RUN_S = 0.2

HEAD = """
#include "processor.h"
#define TIMER ((volatile uint32_t*)0xFF202000)
static volatile unsigned ticks, flag;
static unsigned n;
void __attribute__((interrupt("IRQ"), target("arm"))) on_irq(void) {
    const unsigned id = ICCIAR & 0x3FF;
    A9_TIMER_STATUS = 1;
    ++ticks;
    ICCEOIR = id;
}
static unsigned snapshot(void) { TIMER[4] = 0; return TIMER[4] | TIMER[5] << 16; }
static unsigned cycles(void) {
    unsigned value;
    asm volatile("mrc p15, 0, %0, c9, c13, 0" : "=r"(value));
    return value;
}
static void until_counted(volatile uint32_t* counter, unsigned counts, unsigned down) {
    const unsigned begin = *counter;
    while ((down ? begin - *counter : *counter - begin) < counts) continue;
}
int main(void) {
"""

PROGRAMS = {
    "a flag in memory": "while (!flag) continue;",
    "itself": 'asm volatile("cpsie i"); for (;;) continue;',
    "nested delays": "for (;;) { for (volatile int i = 0; i < 100; i++) "
                     "for (volatile int j = 0; j < 1000; j++) continue; LEDR_DATA = ++n; }",
    "LEDs, all the time": "n = SW_DATA; for (;;) LEDR_DATA = n;",
    "keys": "for (;;) { while (!KEY_DATA) continue; while (KEY_DATA) continue; LEDR_DATA = ++n; }",
    "the private timer's end": "A9_TIMER_LOAD = 200000; A9_TIMER_CONTROL = 3; for (;;) { "
                               "while (!A9_TIMER_STATUS) continue; A9_TIMER_STATUS = 1; }",
    "the private timer": "A9_TIMER_LOAD = ~0u; A9_TIMER_CONTROL = 3; for (;;) { "
                         "until_counted(&REGISTER(0xFFFEC604), 200000, 1); LEDR_DATA = ++n; }",
    "the global timer": "REGISTER(0xFFFEC208) = 1; for (;;) { "
                        "until_counted(&REGISTER(0xFFFEC200), 200000, 0); LEDR_DATA = ++n; }",
    "PMCCNTR": 'asm volatile("mcr p15, 0, %0, c9, c12, 0" : : "r"(5)); '
               'asm volatile("mcr p15, 0, %0, c9, c12, 1" : : "r"(1u << 31)); for (;;) { '
               "const unsigned begin = cycles(); while (cycles() - begin < 800000) continue; "
               "LEDR_DATA = ++n; }",
    "an interval timer's snapshot": "TIMER[2] = TIMER[3] = 0xFFFF; TIMER[1] = 6; for (;;) { n = "
                                    "snapshot(); while (n - snapshot() < 100000) continue; }",
    "an interrupt every us": 'A9_TIMER_LOAD = 199; A9_TIMER_CONTROL = 7; interrupt_on(29); '
                             'asm volatile("cpsie i"); for (;;) continue;',
    "room in the JTAG UART": "for (;;) { while (!(JTAG_UART0_CONTROL >> 16)) continue; "
                             "JTAG_UART0_DATA = 'a' + n++ % 26; }",
    "room for sound": "for (;;) { while (!(AUDIO_FIFOSPACE >> 24)) continue; "
                      "AUDIO_LEFTDATA = AUDIO_RIGHTDATA = n++ << 20; }",
    "the screen's swap": "for (;;) { PIXEL_BUFFER = 1; while (PIXEL_STATUS & 1) continue; ++n; }",
    "the AD converter, always on": "ADC_CH_1 = 1; for (;;) LEDR_DATA = ADC_CH_0 >> 2;",
    "switches, with the camera on": "VIDEO_IN_STATUS = 4; for (;;) LEDR_DATA = SW_DATA;",
}


def processor_s(command):
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def speed(de1sim, elf, out):
    command = [de1sim, "run", "--elf", elf, "--quiet", "--frames", "none", "--out", out]
    short_s, long_s = (processor_s([*command, "--duration", f"{duration * 1e3:.0f}ms"])
                       for duration in (RUN_S / 10, RUN_S))
    with open(os.path.join(out, "report.json"), encoding="utf-8") as file:
        instructions = json.load(file)["program"]["instructions"]
    return 0.9 * RUN_S / (long_s - short_s), instructions / RUN_S / 1e6


def main():
    de1sim, gcc, examples, folder = sys.argv[1:5]
    os.makedirs(folder, exist_ok=True)
    source, elf = (os.path.join(folder, name) for name in ("program.c", "program.elf"))
    speeds = []
    print("programs that wait for, or count by: x real time, simulated million instructions/s")
    for name, body in PROGRAMS.items():
        with open(source, "w", encoding="utf-8") as file:
            file.write(HEAD + body + "\n}\n")
        line = f"  {name:30}"
        for mode in ("arm", "thumb"):
            subprocess.run([gcc, "-O1", f"-m{mode}", "-mcpu=cortex-a9", "-mfpu=neon",
                            "-mfloat-abi=softfp", "-mgeneral-regs-only", "-nostartfiles", "-w",
                            f"-I{examples}", f"-T{examples}/program.ld", f"{examples}/start.S",
                            source, "-o", elf], check=True)
            factor, millions = speed(de1sim, elf, os.path.join(folder, "out"))
            speeds.append(factor)
            line += f"  {mode} {factor:5.2f} x, {millions:5.1f} M"
        print(line, flush=True)
    print(f"  least {min(speeds):.2f} x, median {statistics.median(speeds):.2f} x real time")


if __name__ == "__main__":
    main()
