// Programs that never return from an abort, and others that only seem so (arm/exceptions.S).
#include <gmock/gmock.h>

#include "tb/sim/arm_system.h"

namespace {

using ::testing::HasSubstr;

class ArmFailure : public tb::ArmTest {
protected:
    std::string fault() const { return system->cpu.fault().value_or("none"); }
    std::string unfinished() const { return system->cpu.unfinished().value_or("none"); }

    void spins(const std::string& entry) {
        load(entry);
        run_ms(0.1);
        EXPECT_EQ(fault(), "none");
        EXPECT_THAT(unfinished(), HasSubstr("data abort: read of 4 bytes at 0x80000000"))
            << "however short ago it was";
        run_ms(99);
        EXPECT_EQ(fault(), "none") << "a watchdog may still end it";
        run_ms(2);
        EXPECT_THAT(fault(), HasSubstr("data abort: read of 4 bytes at 0x80000000"));
        EXPECT_THAT(fault(), HasSubstr("; never left its handler: at 100."));
        EXPECT_THAT(fault(), HasSubstr(", PC 0x000"));
        EXPECT_THAT(fault(), HasSubstr(" in " + entry + "+0x"));
    }
    void fails_at_the_runs_end(const std::string& entry) {
        load(entry);
        run_ms(0.9);
        EXPECT_EQ(unfinished(), "none") << "it may still be at it";
        run_ms(0.2);
        EXPECT_THAT(unfinished(), HasSubstr("; never left its handler: at "));
        run_ms(200);
        EXPECT_EQ(fault(), "none") << "it may still come to an end";
        EXPECT_THAT(unfinished(), HasSubstr("; never left its handler: at "));
    }
};

TEST_F(ArmFailure, IsReportedForASpinInAHandler) { spins("test_spin_in_handler"); }

TEST_F(ArmFailure, IsReportedForASpinInThumbCode) { spins("test_thumb_spin_in_handler"); }

TEST_F(ArmFailure, IsReportedForASpinByA32BitThumbInstruction) {
    spins("test_wide_spin_in_handler");
}

TEST_F(ArmFailure, IsReportedForASleepInAHandlerAtTheEnd) {
    fails_at_the_runs_end("test_sleep_in_handler");
}

TEST_F(ArmFailure, IsReportedForASlowHandlerAtTheEndAlone) {
    load("test_slow_handler");
    run_ms(4);
    EXPECT_THAT(unfinished(), HasSubstr("; never left its handler: at 4."));
    run_ms(4);
    EXPECT_TRUE(system->cpu.position().sleeping);
    EXPECT_EQ(unfinished(), "none");
    EXPECT_EQ(fault(), "none");
}

TEST_F(ArmFailure, IsReportedAtTheEndForASpinWithInterruptsEnabled) {
    load("test_spin_with_interrupts");
    run_ms(200);
    EXPECT_EQ(fault(), "none");
    EXPECT_THAT(unfinished(), HasSubstr("; never left its handler: at "));
}

TEST_F(ArmFailure, IsReportedForARunIntoZerosWithTheCaller) {
    load("test_runs_off");
    run_ms(0.1);
    EXPECT_THAT(fault(), HasSubstr("the program ran off its code into zeros at 0.000"));
    EXPECT_THAT(fault(), HasSubstr(", PC 0x00300"));
    EXPECT_THAT(fault(), HasSubstr("; called from inner, outer, test_runs_off"));
}

TEST_F(ArmFailure, IsReportedForARunIntoZerosInThumb) {
    load("test_runs_off_in_thumb");
    run_ms(0.1);
    EXPECT_THAT(fault(),
                HasSubstr("; called from thumb_inner, thumb_outer, test_runs_off_in_thumb"));
}

TEST_F(ArmFailure, IsNotReportedForManyAbortsWhoseHandlerReturns) {
    load("test_many_aborts");
    for (int i = 0; i < 50; ++i) {
        run_ms(0.0917);
        ASSERT_EQ(unfinished(), "none") << i;
    }
    EXPECT_GT(system->cpu.counts().aborts, 1000u);
}

TEST_F(ArmFailure, IsNotReportedForASpinAfterAHandledAbort) {
    load("test_spin_behind_aborts");
    run_ms(200);
    EXPECT_EQ(system->cpu.counts().aborts, 2u);
    EXPECT_EQ(unfinished(), "none");
    EXPECT_EQ(fault(), "none");
}

}  // namespace
