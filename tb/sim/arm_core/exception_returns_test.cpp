// Returns from exceptions: what is computed, and what aborts (ARM ARM, B9.3).  How they change
// modes and registers is compared with Unicorn's.
#include <gmock/gmock.h>

#include "tb/sim/arm_core/system_bench.h"

namespace exception_returns {

using namespace tb::core;
using sim::ArmStop;

constexpr std::uint32_t LAND = 0x9000;

class ExceptionReturns : public SystemTest {};

// B1.9.8: the base is as it was, nothing has been returned from.
TEST_P(ExceptionReturns, ThatAbortHaveNoEffect) {
    const Both accesses[] = {
        {0xF8B10A00, 0xE9B1C000},  // RFEIA r1!
        {0xF96D0513, 0xE82DC013},  // SRSDB sp!, #SVC
        {0xF8ED0512, 0xE9ADC012},  // SRSIA sp!, #IRQ
        {0xE8F18001, 0},           // LDM r1!, {r0, pc}^
        {0xE8D17F01, 0},           // LDM r1, {r0, r8-r14}^
        {0xE8C17F01, 0},           // STM r1, {r0, r8-r14}^
    };
    for (const std::uint32_t place : {REFUSED + 16, NOTHING + 16})
        for (const Both access : accesses) {
            if (thumb() && !access.thumb) continue;
            SCOPED_TRACE(access.arm);
            for (const std::uint32_t each : MODES) {
                become(each);
                set(13, place);
                set(14, each);
            }
            become(SVC | C);
            bench.core.set_spsr(USR);
            set(0, 55);
            set(1, place);
            const std::uint64_t before = bench.core.instructions();
            EXPECT_EQ(execute(access), ArmStop::DATA_ABORT);
            EXPECT_EQ(bench.core.instructions() - before, 1u);
            EXPECT_EQ(cpsr(), SVC | C);
            EXPECT_EQ(bench.core.pc(), AT);
            EXPECT_EQ(reg(0), 55u);
            EXPECT_EQ(reg(1), place);
            for (const std::uint32_t each : MODES) {
                become(each);
                EXPECT_EQ(reg(13), place);
                EXPECT_EQ(reg(14), each);
            }
        }
}

// B9.3.20: with RRX, with pc as an operand, with and without carry.
TEST_P(ExceptionReturns, GoToWhatIsComputed) {
    if (thumb()) return;  // it has no such instructions
    const struct {
        std::uint32_t word, r1, r2;
        bool carry;
    } returns[] = {
        {0xE091F102, LAND - 0x400, 0x100, false},           // ADDS pc, r1, r2, LSL #2
        {0xE09FF001, LAND - (AT + 8), 0, false},            // ADDS pc, pc, r1
        {0xE051F002, LAND + 0x100, 0x100, false},           // SUBS pc, r1, r2
        {0xE071F002, 0x100, LAND + 0x100, false},           // RSBS pc, r1, r2
        {0xE0F1F002, 0x100, LAND + 0x100, true},            // RSCS pc, r1, r2
        {0xE0F1F002, 0x100, LAND + 0x101, false},           // RSCS pc, r1, r2
        {0xE0D1F002, LAND + 0x100, 0x100, true},            // SBCS pc, r1, r2
        {0xE0D1F002, LAND + 0x100, 0xFF, false},            // SBCS pc, r1, r2
        {0xE0B1F002, LAND, 0, false},                       // ADCS pc, r1, r2
        {0xE0B1F002, LAND - 4, 3, true},                    // ADCS pc, r1, r2
        {0xE011F002, LAND | 0xFF0000, LAND | 0xFF, false},  // ANDS pc, r1, r2
        {0xE031F002, LAND ^ 0x123450, 0x123450, false},     // EORS pc, r1, r2
        {0xE191F002, LAND & 0xF000, LAND & 0xF00, false},   // ORRS pc, r1, r2
        {0xE1D1F002, LAND | 0x660, 0x660, false},           // BICS pc, r1, r2
        {0xE1F0F001, ~LAND, 0, false},                      // MVNS pc, r1
        {0xE1B0F061, LAND << 1, 0, false},                  // MOVS pc, r1, RRX
        {0xE1B0F461, LAND << 8 | LAND >> 24, 0, false},     // MOVS pc, r1, ROR #8
        {0xE1B0F221, LAND << 4, 0, false},                  // MOVS pc, r1, LSR #4
    };
    for (const auto& each : returns) {
        SCOPED_TRACE(each.word);
        bench.put(LAND, {WFI.arm, SPIN.arm});
        become(ABT | (each.carry ? C : 0));
        bench.core.set_spsr(SYS | Z);
        set(1, each.r1);
        set(2, each.r2);
        done({each.word, 0});
        EXPECT_EQ(bench.core.cpsr(), SYS | Z);
        EXPECT_EQ(bench.core.pc(), LAND + 4);
    }
}

INSTANTIATE_TEST_SUITE_P(In, ExceptionReturns, EACH_WAY, name_of_way);

}  // namespace exception_returns
