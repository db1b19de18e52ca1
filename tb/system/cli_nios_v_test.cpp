// cli_nios_v_test.cpp - what de1sim says about a program for Nios V.
#include <gmock/gmock.h>

#include "tb/system/cli.h"

namespace {

using ::testing::ContainsRegex;
using ::testing::HasSubstr;

// Of nios_v_mistakes.c.
enum class NiosVMistake { NOTHING, MSTATUS, MIE, DEVICE_MASK, RETURN };

class NiosVCommand : public tb::CommandLine {
protected:
    using Mistake = NiosVMistake;
    tb::Outcome after(Mistake mistake, const std::vector<std::string>& more = {}) const {
        std::string steps = "steps:\n";
        for (unsigned bit = 0; bit < 3; ++bit)
            if (static_cast<unsigned>(mistake) >> bit & 1)
                steps += "  - hold: {switch: " + std::to_string(bit) + "}\n";
        std::vector<std::string> options{"--elf", NIOS_V_MISTAKES_ELF, "--frames", "none"};
        options.insert(options.end(), more.begin(), more.end());
        return play(scenario(steps + "  - delay: 3ms\n  - press: {key: 0, for: 1ms}\n"
                                     "  - expect-leds: {equals: \"1111111111\", timeout: 3ms}\n"),
                    options);
    }
    void says(Mistake mistake, const std::string& why) const {
        const tb::Outcome outcome = after(mistake);
        EXPECT_EQ(outcome.exit_code, 1);
        EXPECT_THAT(outcome.err, HasSubstr(why));
    }
};

TEST_F(NiosVCommand, ReportsNoInterruptThatWasTaken) {
    const tb::Outcome outcome = after(Mistake::NOTHING);
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_EQ(outcome.err, "");
}

TEST_F(NiosVCommand, ReportsAnInterruptThatMstatusMasks) {
    says(Mistake::MSTATUS, "interrupt 18 (KEY) is pending and not taken: MIE in mstatus is 0");
}

TEST_F(NiosVCommand, ReportsAnInterruptThatMieKeepsBack) {
    says(Mistake::MIE, "interrupt 18 (KEY) is pending and not taken: bit 18 of mie is 0");
}

TEST_F(NiosVCommand, ReportsAnInterruptThatItsDeviceMasks) {
    says(Mistake::DEVICE_MASK,
         "interrupt 18 (KEY) is enabled in mie, and not raised: KEY_EDGE (0xFF20005C) is 0x1, but "
         "KEY_MASK (0xFF200058) is 0x0");
}

TEST_F(NiosVCommand, SaysThatTheProgramHasLeftMain) {
    says(Mistake::RETURN, "the program was at PC 0x");
}

// main() calls add_squares(), and that calls square() four times.
TEST_F(NiosVCommand, ProfilesItsFunctionsAndTheirCalls) {
    const std::string path = folder / "callgrind.out";
    const tb::Outcome outcome =
        play(scenario("duration: 1ms\n"),
             {"--elf", NIOS_V_SUMS_ELF, "--frames", "none", "--profile", path});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    const std::string profile = folder.get("callgrind.out");
    EXPECT_THAT(profile,
                HasSubstr("summary: " + report()["program"]["instructions"].dump() + "\n"));
    EXPECT_THAT(profile, ContainsRegex("cfn=\\([0-9]+\\) square\ncalls=4 0\n0 8\n"));
    EXPECT_THAT(profile, ContainsRegex("cfn=\\([0-9]+\\) add_squares\ncalls=1 0\n"));
}

TEST_F(NiosVCommand, LogsTheLastCallsBesideTheWaveformsOfAPart) {
    const tb::Outcome outcome = play(scenario("duration: 200us\n"),
                                     {"--elf", NIOS_V_SUMS_ELF, "--frames", "none", "--trace",
                                      (folder / "w.fst").string(), "--trace-to", "100us"},
                                     {}, DE1SIM "-trace");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_THAT(folder.get("w.calls.txt"),
                ContainsRegex("  add_squares <- main\n([0-9.]+ +square <- add_squares\n){4}"));
    EXPECT_THAT(folder.get("w.bus.txt"), HasSubstr("LEDR"));
}

TEST_F(NiosVCommand, RefusesTheOtherProcessor) {
    const tb::Outcome outcome = after(Mistake::NOTHING, {"--cpu", "arm"});
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_THAT(outcome.err, HasSubstr("is for RISC-V (Nios V), but --cpu arm runs programs for "
                                       "the ARM"));
}

}  // namespace
