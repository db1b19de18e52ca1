// Returns from exceptions, and what handlers save: MOVS pc and its kind, RFE, SRS, LDM and STM with
// ^ (ARM ARM, B9.3).
#include <gmock/gmock.h>

#include "tb/sim/arm_core/system_bench.h"

namespace exception_returns {

using namespace tb::core;
using sim::ArmStop;

constexpr std::uint32_t LAND = 0x9000, PLACE = 0x5000;
constexpr std::uint32_t HANDLERS[] = {FIQ, IRQ, SVC, ABT, UND};
// Where handlers return to.
constexpr std::uint32_t STATES[] = {USR | N,     USR | T | C,     SYS | I | GE, SYS | T | A,
                                    SVC | T | V, FIQ | I | F | Z, UND | N | V,  IRQ | T | E};

class ExceptionReturns : public SystemTest {
protected:
    static std::uint32_t stack(std::uint32_t mode) {
        return 0x20000 + 0x1000 * (mode == USR ? SYS : mode);
    }
    void SetUp() override {
        for (const std::uint32_t to : MODES) {
            become(to);
            set(13, stack(to));
        }
    }
    // The WFI at LAND has been executed, in the state that was saved.
    void expect_landed(std::uint32_t saved) {
        EXPECT_EQ(bench.core.cpsr(), saved);
        EXPECT_EQ(bench.core.pc(), LAND + (saved & T ? 2 : 4));
        EXPECT_EQ(reg(13), stack(saved & MODE)) << "of the mode " << std::hex << saved;
    }
    void each_return(const std::function<void(std::uint32_t from, std::uint32_t saved)>& test) {
        for (const std::uint32_t from : HANDLERS)
            for (const std::uint32_t saved : STATES) {
                SCOPED_TRACE(from);
                SCOPED_TRACE(saved);
                put_landing(LAND, saved & T);
                become(from | A | I | F | Z);
                bench.core.set_spsr(saved);
                test(from, saved);
                expect_landed(saved);
            }
    }
};

// B9.3.19, B9.3.20
TEST_P(ExceptionReturns, FollowTheLinkAndRestoreTheState) {
    each_return([&](std::uint32_t, std::uint32_t) {
        set(14, LAND);
        done({0xE1B0F00E, 0xF3DE8F00});  // MOVS pc, lr
    });
    each_return([&](std::uint32_t, std::uint32_t saved) {
        set(14, LAND + 4 + (saved & T ? 1 : 0));
        done({0xE25EF004, 0xF3DE8F04});  // SUBS pc, lr, #4
    });
}

TEST_P(ExceptionReturns, GoOnInTheMidstOfAnItBlock) {
    bench.put_halves(LAND, {0x3001, 0x3010, 0x3020, 0xBF30, 0xE7FE});  // ADDEQ ADDNE ADD WFI B
    become(IRQ);
    set(0, 0);
    set(14, LAND);
    bench.core.set_spsr(USR | T | 0x0C00);  // as after ITE EQ
    ASSERT_EQ(execute({0xE1B0F00E, 0xF3DE8F00}), ArmStop::WFI);
    EXPECT_EQ(reg(0), 0x30u);
    EXPECT_EQ(bench.core.cpsr(), USR | T) << "the third sets flags";
    EXPECT_EQ(bench.core.instructions(), 5u);
}

struct Multiple {
    Both instruction;  // with r1; SRS: with the stack of mode 0
    std::int32_t first, new_base;
};

// B9.3.13
TEST_P(ExceptionReturns, TakeAddressAndStateFromMemory) {
    const Multiple rfes[] = {
        {{0xF8910A00, 0xE991C000}, 0, 0},    // RFEIA r1
        {{0xF8B10A00, 0xE9B1C000}, 0, 8},    // RFEIA r1!
        {{0xF9110A00, 0xE811C000}, -8, 0},   // RFEDB r1
        {{0xF9310A00, 0xE831C000}, -8, -8},  // RFEDB r1!
        {{0xF9910A00, 0}, 4, 0},             // RFEIB r1
        {{0xF9B10A00, 0}, 4, 8},             // RFEIB r1!
        {{0xF8110A00, 0}, -4, 0},            // RFEDA r1
        {{0xF8310A00, 0}, -4, -8},           // RFEDA r1!
    };
    for (const Multiple& rfe : rfes) {
        if (thumb() && !rfe.instruction.thumb) continue;
        SCOPED_TRACE(rfe.instruction.arm);
        each_return([&](std::uint32_t, std::uint32_t saved) {
            set(1, PLACE);
            bench.core.set_spsr(0);
            bench.put(PLACE + rfe.first, {LAND, saved});
            done(rfe.instruction);
            EXPECT_EQ(reg(1), PLACE + rfe.new_base);
        });
    }
}

// B9.3.16
TEST_P(ExceptionReturns, AreSavedOnTheStackOfAnyMode) {
    const Multiple srss[] = {
        {{0xF8CD0500, 0xE98DC000}, 0, 0},    // SRSIA sp, #mode
        {{0xF8ED0500, 0xE9ADC000}, 0, 8},    // SRSIA sp!, #mode
        {{0xF94D0500, 0xE80DC000}, -8, 0},   // SRSDB sp, #mode
        {{0xF96D0500, 0xE82DC000}, -8, -8},  // SRSDB sp!, #mode
        {{0xF9CD0500, 0}, 4, 0},             // SRSIB sp, #mode
        {{0xF9ED0500, 0}, 4, 8},             // SRSIB sp!, #mode
        {{0xF84D0500, 0}, -4, 0},            // SRSDA sp, #mode
        {{0xF86D0500, 0}, -4, -8},           // SRSDA sp!, #mode
    };
    std::uint32_t value = 0x1234;
    for (const Multiple& srs : srss)
        for (const std::uint32_t from : HANDLERS)
            for (const std::uint32_t to : MODES) {
                if (thumb() && !srs.instruction.thumb) continue;
                SetUp();
                become(from);
                set(14, ++value);
                bench.core.set_spsr(~value);
                bench.put(stack(to) - 12, {1, 2, 3, 4, 5, 6});
                std::vector<std::uint32_t> expected{1, 2, 3, 4, 5, 6};
                expected[(srs.first + 12) / 4] = value;
                expected[(srs.first + 12) / 4 + 1] = ~value;
                done({srs.instruction.arm | to, srs.instruction.thumb | to});
                std::vector<std::uint32_t> found;
                for (unsigned i = 0; i < 6; ++i)
                    found.push_back(bench.word(stack(to) - 12 + 4 * i));
                EXPECT_EQ(found, expected) << std::hex << srs.instruction.arm << " " << from;
                EXPECT_EQ(mode(), from);
                for (const std::uint32_t each : MODES) {
                    become(each);
                    EXPECT_EQ(reg(13), stack(each) + (each == to ? srs.new_base : 0))
                        << std::hex << srs.instruction.arm << " " << from << " " << each;
                }
            }
}

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

INSTANTIATE_TEST_SUITE_P(In, ExceptionReturns,
                         ::testing::Combine(::testing::Bool(), ::testing::Bool()), name_of_way);

// ---- ARM alone ----------------------------------------------------------------------------------

class ArmExceptionReturns : public ExceptionReturns {};

// B9.3.20: with RRX, with pc as an operand, with and without carry.
TEST_P(ArmExceptionReturns, GoToWhatIsComputed) {
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
        put_landing(LAND, false);
        become(ABT | (each.carry ? C : 0));
        bench.core.set_spsr(SYS | Z);
        set(1, each.r1);
        set(2, each.r2);
        done({each.word, 0});
        expect_landed(SYS | Z);
    }
}

// B9.3.5
TEST_P(ArmExceptionReturns, RestoreTheStateFromSpsrWhenPcIsLoadedLast) {
    const Multiple loads[] = {
        {{0xE8F18005, 0}, 0, 12},     // LDM r1!, {r0, r2, pc}^
        {{0xE9718005, 0}, -12, -12},  // LDMDB r1!, {r0, r2, pc}^
        {{0xE9F18005, 0}, 4, 12},     // LDMIB r1!, {r0, r2, pc}^
        {{0xE8718005, 0}, -8, -12},   // LDMDA r1!, {r0, r2, pc}^
        {{0xE8D18005, 0}, 0, 0},      // LDM r1, {r0, r2, pc}^
    };
    for (const Multiple& load : loads) {
        SCOPED_TRACE(load.instruction.arm);
        each_return([&](std::uint32_t, std::uint32_t) {
            set(1, PLACE);
            bench.put(PLACE + load.first, {77, 88, LAND});
            done(load.instruction);
            EXPECT_EQ(reg(0), 77u);
            EXPECT_EQ(reg(1), PLACE + load.new_base);
            EXPECT_EQ(reg(2), 88u);
        });
    }
}

// B9.3.6, B9.3.17
TEST_P(ArmExceptionReturns, SaveAndRestoreTheRegistersOfTheUserMode) {
    for (const std::uint32_t from : HANDLERS) {
        SCOPED_TRACE(from);
        become(USR);
        for (unsigned i = 8; i <= 14; ++i) set(i, 0x100 + i);
        become(from);
        const unsigned first_own = from == FIQ ? 8 : 13;
        for (unsigned i = first_own; i <= 14; ++i) set(i, 0x200 + i);
        set(0, 50);
        set(1, PLACE);
        done({0xE8C17F01, 0});  // STM r1, {r0, r8-r14}^
        EXPECT_EQ(bench.word(PLACE), 50u);
        for (unsigned i = 8; i <= 14; ++i) EXPECT_EQ(bench.word(PLACE + 4 * i - 28), 0x100 + i);
        done({0xE941E000, 0});  // STMDB r1, {sp, lr, pc}^
        EXPECT_EQ(bench.word(PLACE - 12), 0x10Du);
        EXPECT_EQ(bench.word(PLACE - 4), AT + 8);

        bench.put(PLACE, {60, 1, 2, 3, 4, 5, 6, 7});
        done({0xE8D17F01, 0});  // LDM r1, {r0, r8-r14}^
        EXPECT_EQ(reg(0), 60u);
        for (unsigned i = first_own; i <= 14; ++i) EXPECT_EQ(reg(i), 0x200 + i);
        EXPECT_EQ(mode(), from);
        become(USR);
        for (unsigned i = 8; i <= 14; ++i) EXPECT_EQ(reg(i), i - 7);
    }
}

INSTANTIATE_TEST_SUITE_P(Only, ArmExceptionReturns,
                         ::testing::Combine(::testing::Values(false), ::testing::Bool()),
                         name_of_way);

}  // namespace exception_returns
