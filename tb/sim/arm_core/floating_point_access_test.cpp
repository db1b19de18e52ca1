// VFP and NEON can be used where CPACR allows it (ARM ARM, B1.11.1, B9.3.21 - B9.3.22).  FPEXC's
// part is compared with Unicorn's, which does not ask CPACR.
#include <gmock/gmock.h>

#include "tb/sim/arm_core/system_bench.h"

namespace floating_point_access {

using namespace tb::core;

constexpr std::uint32_t ALL = 0x00F00000, PRIVILEGED = 0x00500000;

// With r1 an address.
constexpr Both INSTRUCTIONS[] = {
    {0xEEB70A00, 0xEEB70A00},  // VMOV.F32 s0, #1
    {0xEE300A81, 0xEE300A81},  // VADD.F32 s0, s1, s2
    {0xED910A00, 0xED910A00},  // VLDR s0, [r1]
    {0xEEF12A10, 0xEEF12A10},  // VMRS r2, FPSCR
    {0xEEE11A10, 0xEEE11A10},  // VMSR FPSCR, r1
    {0xEEF1FA10, 0xEEF1FA10},  // VMRS APSR_nzcv, FPSCR
    {0xF2210802, 0xEF210802},  // VADD.I32 d0, d1, d2
    {0xF2310012, 0xEF310012},  // VQADD.S64 d0, d1, d2
    {0xF2010F12, 0xEF010F12},  // VRECPS.F32 d0, d1, d2
    {0xF421078F, 0xF921078F},  // VLD1.32 {d0}, [r1]
};
constexpr Both OF_PRIVILEGED_MODES[] = {
    {0xEEF02A10, 0xEEF02A10},  // VMRS r2, FPSID
    {0xEEF72A10, 0xEEF72A10},  // VMRS r2, MVFR0
    {0xEEF62A10, 0xEEF62A10},  // VMRS r2, MVFR1
    {0xEEF82A10, 0xEEF82A10},  // VMRS r2, FPEXC
    {0xEEE82A10, 0xEEE82A10},  // VMSR FPEXC, r2
};

class FloatingPointAccess : public SystemTest {};

// In one mode after the other, with other instructions before them and without.
TEST_P(FloatingPointAccess, IsWhatCpacrAllows) {
    for (const std::uint32_t cpacr : {ALL, 0u, PRIVILEGED, ALL, PRIVILEGED, 0u, ALL}) {
        become(SVC);
        set(1, cpacr);
        done(mcr(sim::cp15::CPACR));
        for (const std::uint32_t mode : {SVC, USR, SYS, USR}) {
            become(mode);
            set(1, 0x4000);
            for (const Both instruction : INSTRUCTIONS)
                cpacr == ALL || (cpacr && mode != USR) ? done(instruction) : refused(instruction);
            if (mode == USR) continue;
            for (const Both instruction : OF_PRIVILEGED_MODES)
                cpacr ? done(instruction) : refused(instruction);
        }
    }
}

// The same instruction, translated for the mode before.
TEST_P(FloatingPointAccess, IsAskedForAtEachChangeOfTheMode) {
    bench.core.set_cp15(sim::cp15::CPACR, PRIVILEGED);
    put(INSTRUCTIONS[1]);
    for (const std::uint32_t mode : {SVC, USR, SVC, USR}) {
        become(mode);
        set(15, AT);
        EXPECT_EQ(run(), mode == USR ? sim::ArmStop::UNDEFINED : sim::ArmStop::WFI);
    }
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

INSTANTIATE_TEST_SUITE_P(In, FloatingPointAccess, EACH_WAY, name_of_way);

}  // namespace floating_point_access
