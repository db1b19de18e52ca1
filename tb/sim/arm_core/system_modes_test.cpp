// Modes and their banked registers, CPS, MRS and MSR, as the ARM ARM has them (B1.3, B9.3).
#include <gmock/gmock.h>

#include "tb/sim/arm_core/system_bench.h"

namespace system_modes {

using namespace tb::core;

class SystemModes : public SystemTest {
protected:
    // Gives each mode other registers, and sees whether each has kept its own.
    void expect_own_registers(const std::function<void(std::uint32_t mode)>& change) {
        for (const std::uint32_t to : MODES) {
            change(to);
            set(13, 0x1300 + to);
            set(14, 0x1400 + to);
            for (unsigned i = 8; i <= 12; ++i) set(i, 0x100 * i + (to == FIQ ? FIQ : SYS));
            set(1, 0x5000001F + (to << 8));
            if (to != SYS) done(msr_spsr(ALL_FIELDS));
        }
        for (const std::uint32_t to : MODES) {
            SCOPED_TRACE(to);
            change(to);
            EXPECT_EQ(mode(), to);
            EXPECT_EQ(reg(13), 0x1300 + to);
            EXPECT_EQ(reg(14), 0x1400 + to);
            for (unsigned i = 8; i <= 12; ++i)
                EXPECT_EQ(reg(i), 0x100 * i + (to == FIQ ? FIQ : SYS)) << i;
            if (to == SYS) continue;
            done(MRS_SPSR);
            EXPECT_EQ(reg(2), 0x5000001F + (to << 8));
        }
        become(USR);
        EXPECT_EQ(reg(13), 0x1300 + SYS) << "the system mode has those of the user mode";
        EXPECT_EQ(reg(14), 0x1400 + SYS);
    }
};

// B1.3.2
TEST_P(SystemModes, KeepTheirRegistersWhenCpsChangesThem) {
    expect_own_registers([&](std::uint32_t to) { done(cps(to)); });
}
TEST_P(SystemModes, KeepTheirRegistersWhenMsrChangesThem) {
    expect_own_registers([&](std::uint32_t to) {
        set(1, to | I | F);
        done(msr_cpsr(1));
        EXPECT_EQ(cpsr() & (I | F), I | F);
    });
}

// B9.3.2
TEST_P(SystemModes, MaskByCpsWhatItNames) {
    become(SVC | N | A | I | F);
    const struct {
        Both cps;
        std::uint32_t expected;
    } steps[] = {
        {{0xF10801C0, 0xB667}, SVC},                  // CPSIE aif
        {{0xF10C0080, 0xB672}, SVC | I},              // CPSID i
        {{0xF10C0040, 0xB671}, SVC | I | F},          // CPSID f
        {{0xF1080080, 0xB662}, SVC | F},              // CPSIE i
        {{0xF10C0100, 0xB674}, SVC | A | F},          // CPSID a
        {{0xF10C01C0, 0xB677}, SVC | A | I | F},      // CPSID aif
        {{0xF10A009F, 0xF3AF855F}, SYS | A | F},      // CPSIE i, #SYS
        {{0xF10E00D1, 0xF3AF8771}, FIQ | A | I | F},  // CPSID if, #FIQ
        {{0xF10A0153, 0xF3AF85B3}, SVC | I},          // CPSIE af, #SVC
        {{0xF1020012, 0xF3AF8112}, IRQ | I},          // CPS #IRQ
    };
    for (const auto& step : steps) {
        done(step.cps);
        EXPECT_EQ(cpsr(), N | step.expected) << std::hex << step.cps.arm;
    }
}

// B9.3.11: each field is a byte; T, J and IT are not written.
TEST_P(SystemModes, WriteByMsrTheFieldsThatItNames) {
    const std::uint32_t of_field[] = {I | F | MODE, E | A, GE, 0xF8000000};
    for (unsigned fields = 1; fields <= ALL_FIELDS; ++fields) {
        std::uint32_t expected = 0;
        for (unsigned i = 0; i < 4; ++i)
            if (fields >> i & 1) expected |= of_field[i];
        become(SVC);
        set(1, ~0u);
        done(msr_cpsr(fields));
        EXPECT_EQ(cpsr(), SVC | expected) << fields;

        become(SYS | 0xF8000000 | GE | E | A | I | F);
        set(1, SVC);
        done(msr_cpsr(fields));
        const std::uint32_t mode = fields & 1 ? SVC : 0;
        EXPECT_EQ(cpsr(), ((0xF8000000 | GE | E | A | I | F | MODE) & ~expected) | mode) << fields;
    }
}
TEST_P(SystemModes, WriteBytesOfTheSpsrByMsr) {
    for (unsigned fields = 1; fields <= ALL_FIELDS; ++fields) {
        std::uint32_t bytes = 0;
        for (unsigned i = 0; i < 4; ++i)
            if (fields >> i & 1) bytes |= 0xFFu << (8 * i);
        set(1, 0x9ABCDEF0);
        done(msr_spsr(ALL_FIELDS));
        set(1, 0x12345678);
        done(msr_spsr(fields));
        done(MRS_SPSR);
        EXPECT_EQ(reg(2), (0x9ABCDEF0 & ~bytes) | (0x12345678 & bytes)) << fields;
    }
}

// B9.3.8: T, J and IT are hidden.
TEST_P(SystemModes, ShowByMrsWhatIsNotOfTheExecutionState) {
    become(0xF8000000 | GE | A | F | ABT);
    done(MRS_CPSR);
    EXPECT_EQ(reg(2), 0xF8000000 | GE | A | F | ABT);
}

// ---- The user mode (B1.3.1, B9.3) ---------------------------------------------------------------

TEST_P(SystemModes, OfTheUserAreNotLeftByCps) {
    become(USR | Z);
    for (const Both cps : {
             Both{0xF10A009F, 0xF3AF855F},  // CPSIE i, #SYS
             Both{0xF10C01C0, 0xB677},      // CPSID aif
             Both{0xF1020013, 0xF3AF8113},  // CPS #SVC
         }) {
        done(cps);
        EXPECT_EQ(cpsr(), USR | Z);
    }
    become(USR | A | I | F);
    done({0xF10801C0, 0xB667});  // CPSIE aif
    EXPECT_EQ(cpsr(), USR | A | I | F);
}

TEST_P(SystemModes, OfTheUserAreNotLeftByMsr) {
    become(USR);
    set(1, 0xFFFFFFC0 | SVC);
    done(msr_cpsr(ALL_FIELDS));
    EXPECT_EQ(cpsr(), 0xF8000000 | GE | E | USR);
    become(USR | A | I | F);
    set(1, SVC);
    done(msr_cpsr(ALL_FIELDS));
    EXPECT_EQ(cpsr(), USR | A | I | F);
}

INSTANTIATE_TEST_SUITE_P(In, SystemModes, ::testing::Combine(::testing::Bool(), ::testing::Bool()),
                         name_of_way);

// ---- Of one instruction set alone ---------------------------------------------------------------

TEST(SystemModesInArm, AreChangedByConditionalInstructionsWhereTheConditionHolds) {
    Bench bench;
    bench.put(AT, {
                      0xE321F0DF,  // MSR CPSR_c, #SYS | I | F
                      0x1321F0D2,  // MSRNE CPSR_c, #IRQ | I | F
                      0x0321F0D1,  // MSREQ CPSR_c, #FIQ | I | F
                      0xE320F003,  // WFI
                      0xEAFFFFFE,  // B to itself
                  });
    for (const std::uint32_t flags : {Z, 0u}) {
        bench.core.set_cpsr(SVC | flags);
        bench.core.set_reg(15, AT);
        EXPECT_EQ(bench.core.run(100), sim::ArmStop::WFI);
        EXPECT_EQ(bench.core.cpsr(), (flags ? FIQ : IRQ) | flags | I | F);
    }
    EXPECT_EQ(bench.core.instructions(), 8u);
}

TEST(SystemModesInThumb, AreReadAndFlagsWrittenInAnItBlock) {
    Bench bench;
    bench.put_halves(AT, {0xBF06,          // ITTE EQ
                          0xF3EF, 0x8200,  // MRSEQ r2, CPSR
                          0xF381, 0x8800,  // MSREQ CPSR_f, r1: it is NE now
                          0x3010,          // ADDNE r0, #16
                          0xBF30, 0xE7FE});
    bench.core.set_reg(1, C);
    bench.core.set_cpsr(SVC | Z | T);
    bench.core.set_reg(15, AT);
    EXPECT_EQ(bench.core.run(100), sim::ArmStop::WFI);
    EXPECT_EQ(bench.core.reg(2), SVC | Z) << "without T and IT";
    EXPECT_EQ(bench.core.reg(0), 16u);
    EXPECT_EQ(bench.core.cpsr(), SVC | C | T);
    EXPECT_EQ(bench.core.instructions(), 5u);
}

}  // namespace system_modes
