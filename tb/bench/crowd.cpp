#include "tb/bench/crowd.h"

#include <filesystem>
#include <fstream>

#include <fmt/format.h>

#include "tb/bench/measured_run.h"

namespace bench {

namespace {

constexpr unsigned SECONDS = 10, PRESS_MS = 40;

std::string press(char key) {
    return fmt::format("  - press: {{keypad: \"{}\", for: {}ms}}\n  - delay: {}ms\n", key, PRESS_MS,
                       PRESS_MS);
}

// Key 2 makes an X, key 0 ten more.
std::string scenario(unsigned shapes) {
    std::string text = "name: crowd\nversion: 1\nsteps:\n  - wait-serial: ready\n";
    for (unsigned i = 0; i < 10; ++i) text += press('2');
    for (unsigned i = 10; i < shapes; i += 10) text += press('0');
    return text + fmt::format("  - delay: {}s\n  - expect-hex: \"{:>6}\"\n", SECONDS, shapes);
}

}  // namespace

bool crowd(const std::string& de1sim, const std::string& folder, const std::string& elf) {
    bool met = true;
    fmt::print("everything on for {} s, --cpu arm: moving, collisions, drawing, sound\n", SECONDS);
    for (const unsigned shapes : {200u, 250u}) {
        const std::string file = fmt::format("{}/crowd_{}.yaml", folder, shapes);
        std::filesystem::create_directories(folder);
        std::ofstream{file} << scenario(shapes);
        const MeasuredRun run = measure_run(de1sim, file, std::nullopt, folder + "/out",
                                            {"--cpu", "arm", "--elf", elf, "--frames", "none"});
        fmt::print("  {} X: {} new pictures in {} frames, processor busy {:.0f} % of a frame\n",
                   shapes, run.swapped, run.shown, 100 * run.busy_share);
        if (shapes == 200) met = run.swapped == run.shown;
    }
    fmt::print("a new picture in every frame with 200 X: {}\n\n", met ? "met" : "MISSED");
    return met;
}

}  // namespace bench
