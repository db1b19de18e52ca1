// cli_ps2_test.cpp - a program that polls the PS/2 ports gets every answer.
#include "tb/system/cli.h"

namespace {

class PolledPs2 : public tb::CommandLine {
protected:
    std::string told(const std::string& devices, const std::vector<std::string>& options) const {
        std::vector<std::string> words = {"--elf", PS2_COMMANDS_ELF, "--frames", "none"};
        words.insert(words.end(), options.begin(), options.end());
        const auto steps = scenario("ps2: [" + devices +
                                    "]\nsteps:\n"
                                    "  - wait-serial: {text: \"\\n\", timeout: 9s}\n");
        const tb::Outcome outcome = play(steps, words);
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        return file("console.txt");
    }
};

TEST_F(PolledPs2, AnswersEveryCommand) {
    EXPECT_EQ(told("keyboard, mouse", {}), "answered 24 of 24\n");
}

TEST_F(PolledPs2, AnswersEveryCommandOfASlowerProgram) {
    EXPECT_EQ(told("mouse, keyboard", {"--cpi", "3.7"}), "answered 24 of 24\n");
}

}  // namespace
