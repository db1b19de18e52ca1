// bench.cpp - how fast the whole is, beside the bare Verilated model in the same run.
//
//   de1sim_bench DE1SIM FOLDER DEMO ELF BOXES BOXES_ELF LOOP
//
// DEMO and BOXES are scenarios, ELF is the board's program, LOOP one that only computes.
//
// Exit 1 if it is slower, or takes more memory, than this project promises.
#include <cstdlib>
#include <exception>

#include <fmt/format.h>

#include "tb/bench/arm_speed.h"
#include "tb/bench/bus_cost.h"
#include "tb/bench/crowd.h"
#include "tb/bench/measured_run.h"
#include "tb/bench/real_time.h"

namespace {

constexpr unsigned SHORT_S = 5, LONG_S = 60;
constexpr double MOST_MB = 300, MOST_GROWTH = 1.1;

bool memory(const std::string& de1sim, const std::string& scenario, const std::string& out) {
    const double shorter = bench::measure_run(de1sim, scenario, SHORT_S, out).peak_mb;
    const double longer = bench::measure_run(de1sim, scenario, LONG_S, out).peak_mb;
    const bool met = longer < MOST_MB && longer < MOST_GROWTH * shorter;
    fmt::print(
        "peak memory after {} s {:.1f} MB, after {} s {:.1f} MB; under {} MB and flat: {}\n\n",
        SHORT_S, shorter, LONG_S, longer, MOST_MB, met ? "met" : "MISSED");
    return met;
}

void bus() {
    const bench::BusCost cost = bench::bus_cost();
    fmt::print("the bus, in wall time through TLM, pins and RTL\n");
    fmt::print("  register read        {:6.0f} ns\n", cost.register_read_ns);
    fmt::print("  register write       {:6.0f} ns\n", cost.register_write_ns);
    fmt::print("  word, 640-byte write {:6.1f} ns\n", cost.burst_write_ns_a_word);
    fmt::print("  word, 640-byte read  {:6.1f} ns\n\n", cost.burst_read_ns_a_word);
}

}  // namespace

int main(int argc, char** argv) try {
    if (argc != 8) {
        fmt::print(stderr, "usage: de1sim_bench DE1SIM FOLDER DEMO ELF BOXES BOXES_ELF LOOP\n");
        return 2;
    }
    setenv("SYSTEMC_DISABLE_COPYRIGHT_MESSAGE", "1", 1);
    std::setvbuf(stdout, nullptr, _IOLBF, 0);
    const std::string de1sim = argv[1], folder = argv[2], demo = argv[3], elf = argv[4];
    const std::string out = folder + "/out";
    const bool fast = bench::real_time(de1sim, out, {demo, elf, argv[5], argv[6]});
    const bool small = memory(de1sim, demo, out);
    bench::arm_speed(de1sim, demo, out, elf, argv[7]);
    const bool full_rate = bench::crowd(de1sim, folder, elf);
    bus();
    fmt::print("again: make bench\n");
    return fast && small && full_rate ? 0 : 1;
} catch (const std::exception& e) {
    fmt::print(stderr, "de1sim_bench: {}\n", e.what());
    return 2;
}
