// Random programs that branch, call and return go the same way on the processor and on Unicorn.
#include <gmock/gmock.h>

#include <cstring>

#include "tb/sim/arm_core/differences.h"
#include "tb/sim/arm_core/machine.h"
#include "tb/sim/arm_core/program.h"

namespace branches {

using namespace tb::core;

// Unicorn does not count the instructions that an IT block leaves out: there are none.
void go(bool thumb) {
    constexpr unsigned PROGRAMS = 150, INSTRUCTIONS = 2000;
    const auto expected = unicorn(), actual = processor(false);
    for (unsigned number = 0; number < PROGRAMS && !::testing::Test::HasFailure(); ++number) {
        Random random{number};
        const Program program = make_program(random, {thumb, false, false, false}, CODE + 0x4000);
        const auto bytes = static_cast<std::uint32_t>(2 * program.code.size());
        State state;
        for (auto& r : state.r) r = static_cast<std::uint32_t>(random());
        state.r[14] = program.blocks.back() | thumb;
        state.cpsr = 0x1D3 | (thumb ? 0x20 : 0);
        std::uint32_t pc[2];
        State after[2];
        Machine* const machines[]{expected.get(), actual.get()};
        for (unsigned i = 0; i < 2; ++i) {
            std::memcpy(&machines[i]->memory->code[0x4000], program.code.data(), bytes);
            machines[i]->code_changed(CODE + 0x4000, bytes);
            machines[i]->set(state);
            pc[i] = machines[i]->run_on(program.blocks[0], INSTRUCTIONS);
            after[i] = machines[i]->state();
        }
        EXPECT_EQ(pc[0], pc[1]) << "program " << number;
        EXPECT_EQ(difference(after[0], after[1], FPSCR_COMPARED), "") << "program " << number;
    }
}

TEST(BranchesAgainstUnicorn, GoToTheSameInArm) { go(false); }
TEST(BranchesAgainstUnicorn, GoToTheSameInThumb) { go(true); }

}  // namespace branches
