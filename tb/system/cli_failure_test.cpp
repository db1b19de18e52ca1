// cli_failure_test.cpp - programs that take an exception and never return from it.
#include <gmock/gmock.h>

#include "tb/system/cli.h"

namespace {

using ::testing::HasSubstr;
using ::testing::MatchesRegex;

class DyingProgram : public tb::CommandLine {
protected:
    void dies(const std::string& elf, const std::string& fault,
              const std::string& steps = "  - wait-serial: ready\n  - delay: 10ms\n") const {
        const tb::Outcome outcome =
            play(scenario("steps:\n" + steps), {"--cpu", "arm", "--elf", elf, "--frames", "none"});
        EXPECT_EQ(outcome.exit_code, 1) << outcome.err;
        EXPECT_FALSE(report()["passed"]);
        ASSERT_EQ(report()["faults"].size(), 1u);
        EXPECT_THAT(report()["faults"][0].get<std::string>(), MatchesRegex(fault));
        EXPECT_THAT(outcome.err, HasSubstr(report()["faults"][0].get<std::string>()));
        EXPECT_EQ(report()["log"]["lines"], 0u) << "it was said already";
    }
};

#define PLACE "at [0-9.]+ ms, PC 0x[0-9A-F]+ in [a-z_+0-9x]+"

TEST_F(DyingProgram, FailsWhenItsUndefinedInstructionEndsInASpinningVector) {
    dies(UNDEFINED_ELF, "undefined instruction: udf #0 " PLACE "; never left its handler: " PLACE);
}

TEST_F(DyingProgram, FailsWhenItsPrefetchAbortEndsInASpinningVector) {
    dies(
        PREFETCH_ABORT_ELF,
        "prefetch abort: no instruction to be read \\(no memory at 0x80000000: [A-Z0-9]+ begins at "
        "0xC0000000; LR 0x[0-9A-F]+; called from main.*\\) at [0-9.]+ ms, PC 0x80000000; "
        "never left its handler: " PLACE);
}

TEST_F(DyingProgram, FailsWhenItsDataAbortEndsInASpinningVector) {
    dies(DATA_ABORT_ELF,
         "data abort: read of 4 bytes at 0xFFC00000 .*" PLACE "; never left its handler: " PLACE);
}

TEST_F(DyingProgram, FailsWhenItsHandlerGoesRoundAndRound) {
    dies(ROUND_AND_ROUND_ELF, "data abort: read of 4 bytes at 0xFFC00000 .*" PLACE
                              "; never left its handler: .* in on_data_abort.*");
}

TEST_F(DyingProgram, FailsWhenTheRunEndsRightAfterIt) {
    dies(UNDEFINED_ELF, ".*never left its handler.*", "  - wait-serial: ready\n  - delay: 20us\n");
}

TEST_F(DyingProgram, EndsTheRunSoonWhenItSpinsOnTheSpot) {
    dies(UNDEFINED_ELF, ".*never left its handler.*",
         "  - expect-leds: {equals: \"1111111111\", timeout: 5s}\n");
    EXPECT_EQ(report()["end"], "firmware fault");
    EXPECT_LT(report()["simulated_s"], 0.2);
}

}  // namespace
