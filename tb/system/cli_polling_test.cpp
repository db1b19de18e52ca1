// cli_polling_test.cpp - a program that polls gets every answer of a PS/2 device, and every press.
#include <random>

#include <fmt/format.h>

#include "tb/system/cli.h"

namespace {

class PolledPs2 : public tb::CommandLine {
protected:
    std::string reported(const std::string& devices,
                         const std::vector<std::string>& options) const {
        std::vector<std::string> arguments = {"--elf", PS2_COMMANDS_ELF, "--frames", "none"};
        arguments.insert(arguments.end(), options.begin(), options.end());
        const auto steps = scenario("ps2: [" + devices +
                                    "]\nsteps:\n"
                                    "  - wait-serial: {text: \"\\n\", timeout: 9s}\n");
        const tb::Outcome outcome = play(steps, arguments);
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        return file("console.txt");
    }
};

TEST_F(PolledPs2, AnswersEveryCommand) {
    EXPECT_EQ(reported("keyboard, mouse", {}), "answered 24 of 24\n");
}

TEST_F(PolledPs2, AnswersEveryCommandOfASlowerProgram) {
    EXPECT_EQ(reported("mouse, keyboard", {"--cpi", "3.7"}), "answered 24 of 24\n");
}

using PolledKeys = tb::CommandLine;

TEST_F(PolledKeys, ShowEveryPressOfOneClock) {
    std::mt19937 random{1};
    std::string steps = "steps:\n  - delay: 1ms\n";
    for (int n = 0; n < 300; ++n)
        steps += fmt::format("  - delay: {}ns\n  - press: {{key: {}, for: 40ns}}\n",
                             5'000 + random() % 30'000, n % 4);
    steps += "  - delay: 60ms\n  - expect-leds: \"0100101100\"\n";  // 300, without flicker
    for (const char* cpi : {"1", "4.3"}) {
        const tb::Outcome outcome =
            play(scenario(steps), {"--elf", COUNTS_EDGES_ELF, "--cpi", cpi, "--frames", "none"});
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    }
}

}  // namespace
