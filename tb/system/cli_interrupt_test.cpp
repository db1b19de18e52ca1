// cli_interrupt_test.cpp - a run that failed says which interrupt was not taken, and why.
#include <gmock/gmock.h>

#include "tb/system/cli.h"

namespace {

using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::Not;

// Of interrupt_mistakes.c.
enum Mistake {
    NOTHING,
    TARGET,
    PRIORITY_MASK,
    DEVICE_MASK,
    CPSR_I,
    ENABLE,
    DISTRIBUTOR,
    CPU_INTERFACE,
    END,
    CAUSE,
    ACKNOWLEDGE,
    TIMER_INTERRUPT,
    NON_SECURE
};

class MissedInterrupt : public tb::CommandLine {
protected:
    // With two presses of KEY0.
    tb::Outcome after(Mistake mistake) const {
        const std::string switches = std::to_string(mistake);
        std::string steps = "steps:\n";
        for (unsigned bit = 0; bit < 4; ++bit)
            if (mistake >> bit & 1) steps += "  - hold: {switch: " + std::to_string(bit) + "}\n";
        steps += "  - delay: 1ms\n";
        return play(scenario(steps + "  - press: {key: 0, for: 1ms}\n  - delay: 2ms\n"
                                     "  - press: {key: 0, for: 1ms}\n"
                                     "  - expect-leds: {equals: \"1111111111\", timeout: 3ms}\n"),
                    {"--elf", INTERRUPT_MISTAKES_ELF, "--frames", "none"});
    }
    void says(Mistake mistake, const std::string& why) const {
        const tb::Outcome outcome = after(mistake);
        EXPECT_EQ(outcome.exit_code, 1);
        EXPECT_THAT(outcome.err, ContainsRegex("the program was at PC 0x0[0-9A-F]+ in "));
        EXPECT_THAT(outcome.err, HasSubstr(why));
        const auto lines = tb::lines_of(outcome.err);
        const auto about = [](const std::string& line) {
            return line.find("interrupt ") != std::string::npos;
        };
        EXPECT_EQ(std::count_if(lines.begin(), lines.end(), about), 1) << outcome.err;
    }
};

TEST_F(MissedInterrupt, IsNotReportedForOneThatWasTaken) {
    const tb::Outcome outcome = after(NOTHING);
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_EQ(outcome.err, "");
}

TEST_F(MissedInterrupt, IsKeptBackByTheProgramsMistake) {
    for (const auto& [mistake, why] :
         {std::pair{TARGET, "byte 0xFFFED849 of ICDIPTR is 0x00: CPU0 is not its target"},
          {PRIORITY_MASK, "ICCPMR (0xFFFEC104) is 0x00, which keeps its priority of 0x00 back"},
          {CPSR_I, "CPSR.I is 1: the program has masked interrupts (cpsie i lets them in)"},
          {ENABLE, "its bit 9 of ICDISER2 (0xFFFED108) is 0"},
          {DISTRIBUTOR, "bit 0 of ICDDCR (0xFFFED000) is 0"},
          {CPU_INTERFACE, "bit 0 of ICCICR (0xFFFEC100) is 0"},
          {END, "interrupt 73 is still active: ICCEOIR (0xFFFEC110) was not written"}})
        says(mistake, std::string{"not taken: "} + why + "\n");
}

TEST_F(MissedInterrupt, IsMaskedInTheDevice) {
    says(DEVICE_MASK,
         "interrupt 73 (KEY) is enabled in the distributor, and not raised: "
         "KEY_EDGE (0xFF20005C) is 0x1, but KEY_MASK (0xFF200058) is 0x0\n");
}

TEST_F(MissedInterrupt, IsTakenAgainAndAgainWhileItsCauseLasts) {
    says(CAUSE, "times since its line went up at ");
    says(CAUSE, "its handler does not take the cause away: KEY_EDGE (0xFF20005C) is 0x1\n");
}

TEST_F(MissedInterrupt, IsReportedForAHandlerThatNeverReadsIccIar) {
    says(ACKNOWLEDGE, "and its handler does not read ICCIAR (0xFFFEC10C): it was entered ");
}

TEST_F(MissedInterrupt, IsNotAskedForByTheTimer) {
    says(TIMER_INTERRUPT,
         "interrupt 29 (the private timer) is enabled in the distributor, and not "
         "raised: its status (0xFFFEC60C) is 0x1, but its control (0xFFFEC608) is "
         "0x1, where 0x4 has to be 1\n");
}

TEST_F(MissedInterrupt, IsNonSecureAndSwitchedOnForSecureOnesAlone) {
    says(NON_SECURE, "ICDISR makes it Non-secure");
}

TEST_F(MissedInterrupt, IsNoneOfAProgramThatPolls) {
    const tb::Outcome outcome =
        play(scenario("steps:\n  - press: {key: 0, for: 1ms}\n"
                      "  - expect-hex: {equals: \"   123\", timeout: 3ms}\n"),
             {"--elf", LEDS_ELF, "--frames", "none"});
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_THAT(outcome.err, Not(HasSubstr("interrupt")));
}

}  // namespace
