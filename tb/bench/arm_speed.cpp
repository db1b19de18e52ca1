#include "tb/bench/arm_speed.h"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

#include "tb/bench/measured_run.h"

namespace bench {

void arm_speed(const std::string& de1sim, const std::string& scenario, const std::string& out,
               const std::string& elf, const std::string& loop) {
    const auto run = [&](const std::vector<std::string>& options, unsigned duration_s) {
        return measure_run(de1sim, scenario, duration_s, out, options);
    };
    std::vector<double> all, no_pictures, native;
    std::uint64_t instructions = 0;
    for (unsigned i = 0; i < RUNS; ++i) {
        const MeasuredRun arm = run({"--cpu", "arm", "--elf", elf}, DURATION_S);
        instructions = arm.instructions;
        all.push_back(arm.cpu_s);
        no_pictures.push_back(
            run({"--cpu", "arm", "--elf", elf, "--frames", "none"}, DURATION_S).cpu_s);
        native.push_back(run({"--frames", "none"}, DURATION_S).cpu_s);
    }
    const double cpu_s = median(no_pictures) - median(native);
    const double png_s = median(all) - median(no_pictures);
    const double in_all = median(all);
    const auto percent = [in_all](double part) { return 100 * std::max(0.0, part) / in_all; };

    const MeasuredRun loop_run = run({"--cpu", "arm", "--elf", loop, "--frames", "none"}, 1);
    const double loop_s = loop_run.cpu_s - median(native) / DURATION_S;

    fmt::print("--cpu arm, {} s of the demo on the board's program; {} runs of each, in turn\n",
               DURATION_S, RUNS);
    fmt::print("  processor {:.0f} %, PNG {:.0f} %, RTL and the rest {:.0f} % of processor time\n",
               percent(cpu_s), percent(png_s), percent(median(native)));
    fmt::print("  million instructions/s: {:.0f} in the demo, {:.0f} in a loop that computes\n\n",
               static_cast<double>(instructions) / 1e6 / cpu_s,
               static_cast<double>(loop_run.instructions) / 1e6 / loop_s);
}

}  // namespace bench
