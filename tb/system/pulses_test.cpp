// pulses_test.cpp - pulses of one clock by steps, while a program is on the bridges all the time.
#include <random>

#include <fmt/format.h>

#include "regmap.h"
#include "sim/scenario/scenario_runner.h"
#include "tb/support/whole_board.h"

namespace {

constexpr unsigned CLOCK_NS = 40;

class Pulses : public tb::WholeBoard {
protected:
    std::vector<std::string> captured;  // "KEY 3", in the order in which the program found them

    void play(const std::string& steps) {
        power_on([this](hal::Mmio& io, hal::Cpu&) { watch(io); });
        const sim::Scenario scenario =
            sim::parse_scenario("name: a\nversion: 1\nsteps:\n" + steps, "a.yaml");
        sim::Observations observations;
        sim::ScenarioRunner runner{"runner", *board, observations, scenario.steps, ""};
        while (!runner.finished()) run_ms(0.1);
        run_ms(0.1);
    }

private:
    void watch(hal::Mmio& io) {
        const std::uint32_t row[160] = {};
        for (;;) {
            take(io, "KEY", regmap::KEY_EDGE);
            take(io, "JP1", regmap::JP1_EDGE);
            take(io, "JP2", regmap::JP2_EDGE);
            io.write_words(regmap::ONCHIP_BASE, row, 160);  // takes 7 us
        }
    }
    void take(hal::Mmio& io, const char* port, std::uint32_t address) {
        const std::uint32_t edges = io.read(address);
        for (unsigned bit = 0; bit < 32; ++bit)
            if (edges >> bit & 1) captured.push_back(fmt::format("{} {}", port, bit));
        if (edges) io.write(address, edges);
    }
};

TEST_F(Pulses, OfOneClockAreCapturedInOrder) {
    std::mt19937 random{1};
    std::string steps;
    std::vector<std::string> expected;
    for (int n = 0; n < 300; ++n) {
        steps += fmt::format("  - delay: {}ns\n", 12'000 + random() % 30'000);
        const auto bit = static_cast<unsigned>(random() % 32);
        switch (random() % 3) {
            case 0:
                expected.push_back(fmt::format("KEY {}", bit % 4));
                steps += fmt::format("  - press: {{key: {}, for: {}ns}}\n", bit % 4, CLOCK_NS);
                break;
            case 1: expected.push_back(fmt::format("JP1 {}", bit)); break;
            case 2: expected.push_back(fmt::format("JP2 {}", bit)); break;
        }
        if (expected.back()[0] == 'J')
            for (const char* level : {"low", "released"})
                steps += fmt::format("  - set-pins: {{{}: {}, level: {}}}\n  - delay: {}ns\n",
                                     expected.back().substr(0, 3) == "JP1" ? "jp1" : "jp2", bit,
                                     level, CLOCK_NS);
    }
    play(steps);
    EXPECT_EQ(captured, expected);
}

}  // namespace
