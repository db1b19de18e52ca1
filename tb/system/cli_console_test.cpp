// cli_console_test.cpp - a scenario that waits for what a program prints, and the program's checks.
#include <gmock/gmock.h>

#include "tb/system/cli.h"

namespace {

using ::testing::HasSubstr;

class ConsoleRun : public tb::CommandLine {
protected:
    tb::Outcome arm(const std::string& elf, const std::string& steps) const {
        return play(scenario("steps:\n" + steps),
                    {"--cpu", "arm", "--elf", elf, "--frames", "none"});
    }
    std::vector<bool> met() const {
        const nlohmann::json report = this->report();
        std::vector<bool> all;
        for (const auto& e : report["expectations"]) all.push_back(e["met"]);
        return all;
    }
};

TEST_F(ConsoleRun, WaitsForATextOncePerTimeItIsPrinted) {
    const tb::Outcome outcome = arm(LEDS_ELF,
                                    "  - wait-serial: ready\n"
                                    "  - wait-serial: {text: ready, timeout: 1ms}\n");
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_EQ(met(), (std::vector<bool>{true, false}));
    EXPECT_THAT(outcome.err, HasSubstr("the console printed 1 character after the last match, "
                                       "but not that: \"\\x0a\""));
}

TEST_F(ConsoleRun, SearchesOnAfterThePreviousMatch) {
    EXPECT_EQ(arm(LEDS_ELF, "  - wait-serial: rea\n  - delay: 1ms\n  - wait-serial: \"dy\\n\"\n")
                  .exit_code,
              0);
    EXPECT_EQ(arm(LEDS_ELF, "  - wait-serial: dy\n  - wait-serial: {text: rea, timeout: 1ms}\n")
                  .exit_code,
              1);
}

TEST_F(ConsoleRun, FindsTextAfterAnyAmountOfOutput) {
    const tb::Outcome outcome = arm(PRINTS_MUCH_ELF,
                                    "  - delay: 1900ms\n"
                                    "  - wait-serial: {text: first, timeout: 1ms}\n"
                                    "  - wait-serial: {text: last, timeout: 1ms}\n");
    EXPECT_EQ(met(), (std::vector<bool>{false, true}));
    EXPECT_THAT(outcome.err, HasSubstr("were too old to be looked at"));
    const nlohmann::json checks = report()["checks"];
    ASSERT_EQ(checks.size(), 2u);
    EXPECT_EQ(checks[0]["name"], "counts");
    EXPECT_FALSE(checks[1]["met"]);
}

}  // namespace
