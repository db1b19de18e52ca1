// bench.cpp - how fast the whole is, beside the bare Verilated model in the same run.
//
//   de1sim_bench DE1SIM SCENARIO FOLDER ELF LOOP
//
// ELF is the board's program, LOOP one that only computes.
//
// Exit 1 if it is slower, or takes more memory, than this project promises.
#include <algorithm>
#include <cstdlib>
#include <exception>
#include <vector>

#include <fmt/format.h>

#include "sim/fpga/fabric.h"
#include "tb/bench/arm_speed.h"
#include "tb/bench/bare_model.h"
#include "tb/bench/bus_cost.h"
#include "tb/bench/crowd.h"
#include "tb/bench/measured_run.h"

namespace {

constexpr unsigned RUNS = 5, DURATION_S = 3;
constexpr double LEAST_RATIO = 0.75;
constexpr unsigned SHORT_S = 5, LONG_S = 60;
constexpr double MOST_MB = 300, MOST_GROWTH = 1.1;

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

bool speed(const std::string& de1sim, const std::string& scenario, const std::string& out) {
    constexpr std::uint64_t CLOCKS = DURATION_S * 1'000'000'000'000 / sim::FABRIC_PERIOD_PS;
    std::vector<double> bare, whole, ratios;
    std::uint64_t frames = 0;
    fmt::print("{} s of the demo, {} clocks; {} runs of each, in turn\n\n", DURATION_S, CLOCKS,
               RUNS);
    fmt::print("{:>4} {:>16} {:>16} {:>12}\n", "run", "bare model, s", "de1sim run, s",
               "bare/whole");
    for (unsigned i = 0; i < RUNS; ++i) {
        bare.push_back(bench::bare_model_s(CLOCKS));
        const bench::MeasuredRun run = bench::measure_run(de1sim, scenario, DURATION_S, out);
        whole.push_back(run.wall_s);
        frames = run.frames;
        ratios.push_back(bare.back() / whole.back());
        fmt::print("{:>4} {:>16.3f} {:>16.3f} {:>12.3f}\n", i + 1, bare.back(), whole.back(),
                   ratios.back());
    }
    const double ratio = median(bare) / median(whole);
    const double megaclocks = static_cast<double>(CLOCKS) / 1e6;
    fmt::print("\n{:32}{:>10}{:>14}{:>16}\n", "medians", "s", "Mclocks/s", "frames/s");
    fmt::print("{:32}{:>10.3f}{:>14.1f}{:>16.1f}\n", "bare Verilated model, plain loop",
               median(bare), megaclocks / median(bare), static_cast<double>(frames) / median(bare));
    fmt::print("{:32}{:>10.3f}{:>14.1f}{:>16.1f}\n", "de1sim run, every frame a PNG", median(whole),
               megaclocks / median(whole), static_cast<double>(frames) / median(whole));
    fmt::print("speed of the whole / of the bare model {:.2f}, at least {:.2f}: {}\n\n", ratio,
               LEAST_RATIO, ratio >= LEAST_RATIO ? "met" : "MISSED");
    return ratio >= LEAST_RATIO;
}

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
    if (argc != 6) {
        fmt::print(stderr, "usage: de1sim_bench DE1SIM SCENARIO FOLDER ELF LOOP\n");
        return 2;
    }
    setenv("SYSTEMC_DISABLE_COPYRIGHT_MESSAGE", "1", 1);
    std::setvbuf(stdout, nullptr, _IOLBF, 0);
    const std::string out = argv[3] + std::string{"/out"};
    const bool fast = speed(argv[1], argv[2], out);
    const bool small = memory(argv[1], argv[2], out);
    const bool arm_fast = bench::arm_speed(argv[1], argv[2], out, argv[4], argv[5]);
    const bool full_rate = bench::crowd(argv[1], argv[3], argv[4]);
    bus();
    fmt::print("again: make bench\n");
    return fast && small && arm_fast && full_rate ? 0 : 1;
} catch (const std::exception& e) {
    fmt::print(stderr, "de1sim_bench: {}\n", e.what());
    return 2;
}
