// VFP and NEON can be used when CPACR and FPEXC allow it (ARM ARM, B1.11.1, B9.3.21 - B9.3.22).
#include <gmock/gmock.h>

#include "tb/sim/arm_core/system_bench.h"

namespace floating_point_access {

using namespace tb::core;

constexpr Both VMSR_FPEXC{0xEEE81A10, 0xEEE81A10}, VMRS_FPEXC{0xEEF82A10, 0xEEF82A10};
constexpr std::uint32_t EN = 1u << 30, ALL = 0x00F00000, PRIVILEGED = 0x00500000;

// With r1 an address.
constexpr Both INSTRUCTIONS[] = {
    {0xEEB70A00, 0xEEB70A00},  // VMOV.F32 s0, #1
    {0xEE300A81, 0xEE300A81},  // VADD.F32 s0, s1, s2
    {0xED910A00, 0xED910A00},  // VLDR s0, [r1]
    {0xEEF12A10, 0xEEF12A10},  // VMRS r2, FPSCR
    {0xEEE11A10, 0xEEE11A10},  // VMSR FPSCR, r1
    {0xEEF1FA10, 0xEEF1FA10},  // VMRS APSR_nzcv, FPSCR
    {0xF2210802, 0xEF210802},  // VADD.I32 d0, d1, d2
    {0xF421078F, 0xF921078F},  // VLD1.32 {d0}, [r1]
};
constexpr Both IDENTIFICATION[] = {
    {0xEEF02A10, 0xEEF02A10},  // VMRS r2, FPSID
    {0xEEF72A10, 0xEEF72A10},  // VMRS r2, MVFR0
    {0xEEF62A10, 0xEEF62A10},  // VMRS r2, MVFR1
};

class FloatingPointAccess : public SystemTest {
protected:
    void set_cpacr(std::uint32_t value) {
        become(SVC);
        set(1, value);
        done(mcr(sim::cp15::CPACR));
    }
    void set_fpexc(std::uint32_t value) {
        become(SVC);
        set(1, value);
        done(VMSR_FPEXC);
    }
    // In that mode, with other instructions before them and without.
    void expect(bool allowed, std::uint32_t mode) {
        become(mode);
        set(1, 0x4000);
        for (const Both instruction : INSTRUCTIONS) {
            SCOPED_TRACE(instruction.arm);
            allowed ? done(instruction) : refused(instruction);
        }
    }
};

TEST_P(FloatingPointAccess, IsEnabledByCpacr) {
    expect(true, SVC);
    expect(true, USR);
    for (unsigned i = 0; i < 2; ++i) {
        set_cpacr(0);
        expect(false, SVC);
        expect(false, USR);
        set_cpacr(ALL);
        expect(true, SVC);
        expect(true, USR);
    }
}

TEST_P(FloatingPointAccess, IsOfPrivilegedModesAloneWhereCpacrSaysSo) {
    set_cpacr(PRIVILEGED);
    for (unsigned i = 0; i < 2; ++i) {
        expect(true, SVC);
        expect(false, USR);
        expect(true, SYS);
    }
    set_cpacr(ALL);
    expect(true, USR);
}

TEST_P(FloatingPointAccess, IsEnabledByFpexc) {
    for (unsigned i = 0; i < 2; ++i) {
        set_fpexc(0);
        expect(false, SVC);
        expect(false, USR);
        set_fpexc(EN);
        expect(true, SVC);
        expect(true, USR);
    }
}

TEST_P(FloatingPointAccess, LeavesFpexcAndTheIdentificationToPrivilegedModes) {
    for (const std::uint32_t enabled : {0u, EN}) {
        set_fpexc(enabled);
        done(VMRS_FPEXC);
        EXPECT_EQ(reg(2) & EN, enabled);
        for (const Both instruction : IDENTIFICATION) done(instruction);
        become(USR);
        for (const Both instruction : IDENTIFICATION) refused(instruction);
        refused(VMRS_FPEXC);
        refused(VMSR_FPEXC);
    }
    done({0xE320F000, 0xBF00});
}

TEST_P(FloatingPointAccess, LeavesNothingAtAllWithoutCpacr) {
    set_cpacr(0);
    for (const Both instruction : IDENTIFICATION) refused(instruction);
    refused(VMRS_FPEXC);
    refused(VMSR_FPEXC);
}

// The same instruction, translated long ago.
TEST_P(FloatingPointAccess, CanEndInTheMidstOfALoop) {
    if (thumb()) return;
    bench.put(AT, {
                      0xEE300A81,                 // VADD.F32 s0, s1, s2
                      0xE2544001,                 // SUBS r4, r4, #1
                      0x1AFFFFFC,                 // BNE to the begin
                      mcr(sim::cp15::CPACR).arm,  // r1 is zero
                      0xEAFFFFFA,                 // B to the begin
                  });
    set(1, 0);
    set(4, 100);
    set(15, AT);
    EXPECT_EQ(run(), sim::ArmStop::UNDEFINED);
    EXPECT_EQ(bench.core.pc(), AT);
    EXPECT_EQ(bench.core.instructions(), 303u);
}

INSTANTIATE_TEST_SUITE_P(In, FloatingPointAccess,
                         ::testing::Combine(::testing::Bool(), ::testing::Bool()), name_of_way);

}  // namespace floating_point_access
