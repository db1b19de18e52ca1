// report_keys.h - every key of report.json, in the file's order, with its meaning
//
// REPORT.md is printed from this table, and a test compares it with the files of real runs.
#pragma once

#include <string_view>

namespace sim {

struct ReportKey {
    // "frames.shown"; of the entries of a list "expectations[].step".  "*" is any name.
    std::string_view path;
    std::string_view what;
};

inline constexpr ReportKey REPORT_KEYS[] = {
    {"format",
     "The version of this file's format: 1. It changes when a key goes or means something else, "
     "not "
     "when keys are added."},
    {"scenario", "The scenario's name; empty if a program ran without one."},
    {"file", "The scenario's file as it was named; empty without one."},
    {"seed", "Seed of the contacts' bounce."},
    {"cpu",
     "`arm`: the modelled Cortex-A9; `nios-v`: Nios V; `native`: firmware compiled for this "
     "machine."},
    {"end",
     "How the run ended: `all steps done`, `duration reached`, `the program ended`, "
     "`interrupted`, `firmware fault`, `stopped by the design`, `oscillation of the design` or "
     "`internal error`."},
    {"interrupted", "Whether a person or a signal ended it."},
    {"passed",
     "Every expectation and every check of the program's was met, nothing faulted, and "
     "nobody interrupted it. Exit code 0."},
    {"simulated_s", "Simulated time, in seconds."},
    {"frames.shown", "Frames that the monitor saw."},
    {"frames.swapped", "Of these, frames that began with a new picture."},
    {"frames.last_sha256", "SHA-256 of the last frame's RGB bytes; empty if there was none."},
    {"frames.signal",
     "What the monitor has locked on to last, or why it has not: size, rate, polarities, clocks; "
     "empty in the first frames."},
    {"frames.pictures.*",
     "SHA-256 of a new picture's RGB bytes, by the number of its frame; of the first 1000 that "
     "differ from the one before."},
    {"bus.reads", "Loads over the bus, of up to a word."},
    {"bus.writes", "Stores over the bus, of up to a word."},
    {"bus.bursts", "Transfers of more than a word."},
    {"bus.errors", "Accesses that were answered with an error."},
    {"audio.rate_hz",
     "Samples per second and channel that the codec played; 0 before it was set up."},
    {"audio.samples", "Samples per channel that were played."},
    {"audio.underruns", "Samples that were due while the FIFO was empty."},
    {"key_events", "Keys of the keypad pressed and released."},
    {"final.ledr", "LEDR at the end, a digit each, LEDR9 first."},
    {"final.hex", "HEX at the end, as text, HEX5 first."},
    {"final.hps_led",
     "The HPS's LED at the end: `1` if it was lit. All three are also in `shown`."},
    {"shown",
     "What is seen without a monitor, by name: `ledr`, `hex`, `hps_led`, `jp1`, `jp2`; of a "
     "project `gpio_0` and `gpio_1` in the place of these two; of a board with that header also "
     "`arduino_io`."},
    {"shown.*.*",
     "What it showed at the end. LEDs: `lit`, a digit each, LEDR9 first; HEX: `text` and "
     "`segments`, "
     "HEX5 first; a header: `levels` of its pins and which are `outputs`, bit 0 for D0 or pin 0."},
    {"shown.*.changes.count", "How often it changed."},
    {"shown.*.changes.first[].time_s", "When, in simulated seconds; the first changes only."},
    {"shown.*.changes.first[].*", "What it showed from then on."},
    {"parts.*.rows[]",
     "What an LED or a matrix of the scenario's parts showed at the end, a row each: `#` lit, `+` "
     "a little, `.` dark."},
    {"parts.*.received",
     "What a terminal of the parts received, the last 65,536 characters or more; what is no text "
     "is "
     "written as `\\x07`."},
    {"parts.*.lost",
     "Bytes that it lost, since their stop bit was low: at another rate, as a rule."},
    {"characters[].row",
     "A row of the character buffer with text in it at the end, from 0 at the top."},
    {"characters[].text", "The text there."},
    {"timing_violations.count", "Deviations of the VGA signal from its standard."},
    {"timing_violations.first[]", "The first 20 of them."},
    {"sdram_violations.count", "Deviations from the SDRAM's datasheet."},
    {"sdram_violations.first[]", "The first 20 of them."},
    {"expectations[].step", "An expectation of the scenario, in words."},
    {"expectations[].line", "Its line in the file."},
    {"expectations[].time_s", "When it was decided, in simulated seconds."},
    {"expectations[].met", "Whether it was met."},
    {"expectations[].detail", "If it was not: what there was instead."},
    {"faults[]", "What went wrong with the run as a whole."},
    {"log.lines", "Notes on what is no failure: aborts that the program handled, resets."},
    {"log.first[]", "The first of them."},
    {"wall.seconds", "Time that the run took on this machine."},
    {"wall.frames_per_s", "Frames per second of that time."},
    {"checks[].name", "A check that the program made itself and printed as TAP."},
    {"checks[].met", "Whether it was `ok`."},
    {"checks[].detail", "What the program said about it."},
    {"program.elf", "The program; this and the following only for `cpu` `arm` and `nios-v`."},
    {"program.cpi", "Clocks per instruction."},
    {"program.instructions", "Instructions executed."},
    {"program.interrupts", "Interrupts taken."},
    {"program.aborts", "Aborts taken."},
    {"program.asleep_s", "Simulated seconds in WFI and WFE."},
    {"program.on_bus_s",
     "Simulated seconds waiting for registers and FPGA memory, polling included."},
    {"program.at.pc", "Where it was at the end."},
    {"program.at.function", "The function there; empty if it has no name."},
    {"program.at.waiting_for", "What it was waiting for there, or empty."},
    {"program.frames.count",
     "Frames that the figures below are taken of; without any they are left "
     "out. A frame is the time from one frame's end to the next. The first 100,000 count."},
    {"program.frames.instructions.*", "Instructions per frame: `min`, `median`, `max`."},
    {"program.frames.busy_share.*", "Share of the frame in which the processor was not asleep."},
    {"program.frames.bus_share.*", "Share of the frame in which it waited for the FPGA."},
    {"program.exit_code",
     "Of a program that has ended on Linux or by semihosting; 130 of one that ^C has ended."},
    {"program.network[]",
     "Only if the run had a network: what of `--network` the program could reach. Such a run is "
     "not reproducible."},
};

}  // namespace sim
