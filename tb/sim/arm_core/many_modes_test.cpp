// A program that runs in many of FPSCR's modes is translated for each of them.  That must not
// exhaust the host's memory.
#include <gtest/gtest.h>

#include <sys/resource.h>

#include "tb/sim/arm_core/bench.h"

namespace many_modes {

using namespace tb::core;

long most_memory_mb() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss / 1024;
}

TEST(ManyModesOfFpscr, TakeNoMoreMemoryThanAFew) {
    constexpr std::uint32_t AT = 0x10000, INSTRUCTIONS = 12 * 1024, MODES = 8;
    Bench bench;
    bench.put(AT, std::vector<std::uint32_t>(INSTRUCTIONS, 0xEE300A20));  // vadd.f32 s0, s0, s1
    const long before = most_memory_mb();
    for (std::uint32_t mode = 0; mode < MODES; ++mode) {
        bench.core.set_fpscr(mode << 22);  // rounding; flush to zero
        for (std::uint32_t i = 0; i < INSTRUCTIONS; ++i) {
            bench.core.set_reg(15, AT + 4 * i);
            ASSERT_EQ(bench.core.run(1), sim::ArmStop::LIMIT);
            ASSERT_LT(most_memory_mb(), before + 300);
        }
    }
}

}  // namespace many_modes
