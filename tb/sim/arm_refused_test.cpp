// Instructions that the Cortex-A9 refuses are named, with the reason and what to do: arm/refused.S.
#include <gmock/gmock.h>

#include "tb/sim/arm_system.h"

namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

class ArmRefused : public tb::ArmTest {
protected:
    // What is logged of a program that goes on after the instruction.
    std::string line_of(const std::string& entry, unsigned vector) {
        run_to_end(entry);
        EXPECT_EQ(record().vector, vector);
        EXPECT_EQ(result(), 99u) << "goes on after it";
        EXPECT_EQ(system->log.size(), 1u);
        return system->log.empty() ? "" : system->log[0];
    }
    static constexpr unsigned UNDEFINED = 1, DATA_ABORT = 4;
};

TEST_F(ArmRefused, IsAnUnalignedLoadWithTheMmuOff) {
    EXPECT_THAT(line_of("test_unaligned_load", DATA_ABORT),
                HasSubstr("data abort: ldr r2, [r1, #0x11] at 0x00008011, expected a multiple of 4 "
                          "(with the MMU off; build with -mno-unaligned-access, align the data by "
                          ".align) at "));
    EXPECT_EQ(record().status, 0x001u) << "alignment fault, read";
    EXPECT_EQ(record().address, address_of("record") + 17);
    EXPECT_EQ(record().link, address_of("at_unaligned_load") + 8);
}

TEST_F(ArmRefused, IsAnUnalignedStoreWithSctlrA) {
    EXPECT_THAT(
        line_of("test_unaligned_store_with_sctlr_a", DATA_ABORT),
        HasSubstr("strh r1, [r1, #1] at 0x00008001, expected a multiple of 2 (with SCTLR.A"));
    EXPECT_EQ(record().status, 0x801u) << "alignment fault, write";
}

TEST_F(ArmRefused, IsAnUnalignedLdmWithoutACompilersOption) {
    EXPECT_THAT(line_of("test_unaligned_multiple", DATA_ABORT),
                AllOf(HasSubstr("ldm r1!, {r2, r3} at 0x00008002, expected a multiple of 4 (in any "
                                "memory; align the data by .align) at "),
                      Not(HasSubstr("-mno-unaligned-access"))));
}

TEST_F(ArmRefused, IsAnUnalignedLoadOfADeviceBeforeTheBusSeesIt) {
    EXPECT_THAT(line_of("test_unaligned_at_the_bus", DATA_ABORT),
                HasSubstr("ldr r2, [r1, #2] at 0xFF200002, expected a multiple of 4"));
    EXPECT_EQ(system->probe.reads, 0u);
}

TEST_F(ArmRefused, IsFloatingPointThatIsNotSwitchedOn) {
    EXPECT_THAT(line_of("test_floating_point_off", UNDEFINED),
                HasSubstr("undefined instruction: vmov s0, r0 (the floating-point unit is off, as "
                          "after reset: switch it on by CPACR and FPEXC"));
}

TEST_F(ArmRefused, IsNeonThatIsNotSwitchedOn) {
    EXPECT_THAT(line_of("test_neon_off", UNDEFINED),
                HasSubstr("undefined instruction: vadd.i32 q0, q1, q2 (the floating-point unit is "
                          "off, as after reset"));
}

TEST_F(ArmRefused, IsFloatingPointThatIsSwitchedOnHalf) {
    EXPECT_THAT(line_of("test_floating_point_half_on", UNDEFINED),
                HasSubstr("the floating-point unit is off"));
}

TEST_F(ArmRefused, IsNoFloatingPointThatIsSwitchedOn) {
    run_to_end("test_floating_point_on");
    EXPECT_EQ(result(), 99u);
    EXPECT_EQ(system->log.size(), 0u);
}

TEST_F(ArmRefused, IsADivisionWhichTheCortexA9DoesNotHave) {
    EXPECT_THAT(
        line_of("test_division", UNDEFINED),
        HasSubstr("undefined instruction: sdiv r1, r1, r2 (SDIV is not in a Cortex-A9; build "
                  "with -mcpu=cortex-a9) at "));
}

TEST_F(ArmRefused, IsADivisionInThumb) {
    load("test_division_in_thumb", 1, true);
    run_ms(1);
    ASSERT_FALSE(system->log.empty());
    EXPECT_THAT(system->log[0], HasSubstr("udiv r1, r1, r2 (UDIV is not in a Cortex-A9"));
}

TEST_F(ArmRefused, IsAFusedMultiplyAlthoughFloatingPointIsOn) {
    EXPECT_THAT(line_of("test_fused_multiply", UNDEFINED),
                HasSubstr("vfma.f32 s0, s2, s4 (VFMA is not in a Cortex-A9"));
}

}  // namespace
