// cli_lamps_test.cpp - what a run shows without a monitor: lamps, digits, pins and characters.
#include <gmock/gmock.h>

#include "tb/system/cli.h"

namespace {

using ::testing::HasSubstr;

class ShownRun : public tb::CommandLine {
protected:
    tb::Outcome run(const std::string& steps) const {
        return play(scenario("steps:\n" + steps), {"--elf", LAMPS_ELF, "--frames", "none"});
    }
};

TEST_F(ShownRun, ReportsTheLampsAndPinsAtTheEnd) {
    const tb::Outcome outcome = run("  - delay: 5ms\n");
    const nlohmann::json shown = report()["shown"];
    EXPECT_EQ(shown["ledr"]["lit"], "1010101010");
    EXPECT_EQ(shown["hex"]["segments"], "00 00 7C 27 67 00");
    EXPECT_THAT(shown["hex"]["text"], testing::AnyOf("  679 ", "  B79 "));
    EXPECT_EQ(shown["hps_led"]["lit"], "1");
    const nlohmann::json final = report()["final"];
    EXPECT_EQ(final["ledr"], shown["ledr"]["lit"]);
    EXPECT_EQ(final["hex"], shown["hex"]["text"]);
    EXPECT_EQ(final["hps_led"], "1");
    EXPECT_EQ(shown["jp1"]["outputs"], "0x0000F000");
    EXPECT_EQ(shown["jp1"]["levels"], "0xFFFF5FFF") << "what nothing drives is pulled up";
    EXPECT_EQ(shown["jp2"]["outputs"], "0x00000000");
    EXPECT_THAT(outcome.out, HasSubstr("LEDR 1010101010, HEX \""));
    EXPECT_THAT(outcome.out, HasSubstr("the HPS's LED is lit, JP1 puts 0x00005000 on 0x0000F000"));
}

TEST_F(ShownRun, ReadsDigitsInBothFormsOf6And7And9) {
    EXPECT_EQ(run("  - delay: 5ms\n  - expect-hex: \"  679 \"\n").exit_code, 0);
}

TEST_F(ShownRun, HasTheCharactersAsTextWithTheirRows) {
    const tb::Outcome outcome = run("  - delay: 5ms\n");
    EXPECT_EQ(report()["characters"], nlohmann::json::parse(R"([{"row": 1, "text": "  score 12"},
                                        {"row": 59, "text": "\"end\""}])"));
    EXPECT_THAT(outcome.out, HasSubstr("  |   score 12\n  | \"end\"\n"));
}

TEST_F(ShownRun, HasTheChangesWithTheirTimes) {
    run("  - delay: 5ms\n");
    const nlohmann::json ledr = report()["shown"]["ledr"]["changes"];
    EXPECT_EQ(ledr["count"], 2u);
    EXPECT_EQ(ledr["first"][0]["lit"], "1000000001");
    EXPECT_EQ(ledr["first"][1]["lit"], "1010101010");
    const double first_s = ledr["first"][0]["time_s"], second_s = ledr["first"][1]["time_s"];
    EXPECT_GT(first_s, 0);
    EXPECT_LT(first_s, second_s);
    EXPECT_LT(second_s, 1e-3);
    EXPECT_EQ(report()["shown"]["hps_led"]["changes"]["count"], 1u);
}

TEST_F(ShownRun, KeepsTheFirstHundredChangesAndCountsTheOthers) {
    run("  - delay: 5ms\n  - press: {key: 0, for: 5ms}\n");
    const nlohmann::json jp1 = report()["shown"]["jp1"];
    EXPECT_EQ(jp1["changes"]["count"], 303u);
    EXPECT_EQ(jp1["changes"]["first"].size(), 100u);
    EXPECT_EQ(jp1["changes"]["first"][99]["levels"], "0xFFFFFC61") << "97";
    EXPECT_EQ(jp1["levels"], "0xFFFFFD2C") << "300";
}

TEST_F(ShownRun, SeesWhatIsDimmedAndMultiplexedAsLit) {
    EXPECT_EQ(run("  - delay: 5ms\n  - press: {key: 0, for: 50ms}\n"
                  "  - expect-leds: \"1111111111\"\n  - expect-hex: \"111111\"\n")
                  .exit_code,
              0);
    EXPECT_LE(report()["shown"]["ledr"]["changes"]["count"], 60u);
    EXPECT_LE(report()["shown"]["hex"]["changes"]["count"], 60u);
}

TEST_F(ShownRun, PrintsNothingOfWhatIsDark) {
    const tb::Outcome outcome =
        play(scenario("duration: 2ms\n"), {"--elf", STANDS_STILL_ELF, "--frames", "none"});
    EXPECT_EQ(tb::lines_of(outcome.out).size(), 1u);
    EXPECT_TRUE(report()["characters"].empty());
}

}  // namespace
