#include "tb/bench/real_time.h"

#include <algorithm>
#include <cstdlib>
#include <thread>
#include <vector>

#include <fmt/format.h>

#include "sim/fpga/fabric.h"
#include "tb/bench/bare_model.h"
#include "tb/bench/measured_run.h"

namespace bench {

namespace {

constexpr double CLOCKS = DURATION_S * 1e12 / sim::FABRIC_PERIOD_PS;

// Frames per second for each Mclock/s of the bare model that leaves nothing out.  That model is
// FASTER times as fast as it was before blocks slept; where it then did 10 Mclocks/s, 60 frames per
// second are wanted with the modelled processor and 75 with the native one.
constexpr double FASTER = 2.4, BEFORE = 10;
constexpr double LEAST_ARM = 60 / (FASTER * BEFORE), LEAST_NATIVE = 75 / (FASTER * BEFORE);
constexpr double LEAST_BOXES = 0.75;  // of the demo's speed

std::string load() {
    double averages[1] = {};
    if (getloadavg(averages, 1) != 1) return "load unknown";
    return fmt::format("load {:.1f} on {} processors", averages[0],
                       std::thread::hardware_concurrency());
}

const char* verdict(bool met) { return met ? "met" : "MISSED"; }

}  // namespace

bool real_time(const std::string& de1sim, const std::string& out, const Programs& programs) {
    fmt::print("real time: {} s with every frame a PNG; {} runs of each, in turn; {}\n", DURATION_S,
               RUNS, load());
    std::vector<double> every, skipping, native, arm, boxes;
    const auto frames_per_s = [&](const std::string& scenario, std::vector<std::string> options) {
        const MeasuredRun run = measure_run(de1sim, scenario, DURATION_S, out, options);
        return static_cast<double>(run.frames) / run.wall_s;
    };
    for (unsigned i = 0; i < RUNS; ++i) {
        const auto clocks = static_cast<std::uint64_t>(CLOCKS);
        every.push_back(CLOCKS / 1e6 / bare_model_s(clocks, false));
        skipping.push_back(CLOCKS / 1e6 / bare_model_s(clocks, true));
        native.push_back(frames_per_s(programs.demo, {}));
        arm.push_back(frames_per_s(programs.demo, {"--cpu", "arm", "--elf", programs.demo_elf}));
        boxes.push_back(
            frames_per_s(programs.boxes, {"--cpu", "arm", "--elf", programs.boxes_elf}));
    }
    constexpr double FRAMES = 1e12 / sim::FABRIC_PERIOD_PS / 420'000;  // per simulated second
    const double bare = median(every);
    fmt::print("  bare model, every clock           {:6.1f} Mclocks/s\n", bare);
    fmt::print("  bare model, idle ones left out    {:6.1f} Mclocks/s\n", median(skipping));
    const auto row = [&](const char* what, double frames, double ratio, double least,
                         const char* of) {
        fmt::print("  {:32}  {:6.1f} frames/s, {:.2f} x real time; {:.2f} {} ({:.2f} wanted: {})\n",
                   what, frames, frames / FRAMES, ratio, of, least, verdict(ratio >= least));
        return ratio >= least;
    };
    const char* const per_clock = "per bare Mclock/s";
    const bool native_met =
        row("demo, --cpu native", median(native), median(native) / bare, LEAST_NATIVE, per_clock);
    const bool arm_met =
        row("demo, --cpu arm", median(arm), median(arm) / bare, LEAST_ARM, per_clock);
    const bool boxes_met = row("boxes, --cpu arm", median(boxes), median(boxes) / median(arm),
                               LEAST_BOXES, "of the demo's");
    fmt::print("\n");
    return native_met && arm_met && boxes_met;
}

}  // namespace bench
