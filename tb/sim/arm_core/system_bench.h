// system_bench.h - single instructions of an operating system, in ARM and in Thumb, translated and
// in single steps.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <tuple>

#include "tb/sim/arm_core/bench.h"

namespace tb::core {

constexpr std::uint32_t AT = 0x8000;
constexpr std::uint32_t N = 1u << 31, Z = 1u << 30, C = 1u << 29, V = 1u << 28, GE = 0xF0000;
constexpr std::uint32_t E = 0x200, A = 0x100, I = 0x80, F = 0x40, T = 0x20;
constexpr std::uint32_t USR = 0x10, FIQ = 0x11, IRQ = 0x12, SVC = 0x13, ABT = 0x17, UND = 0x1B,
                        SYS = 0x1F, MODE = 0x1F;
constexpr std::uint32_t MODES[] = {FIQ, IRQ, SVC, ABT, UND, SYS};

// An instruction in both sets; a Thumb one as in sim/cpu/dynarmic/instructions.h.
struct Both {
    std::uint32_t arm, thumb;
};

constexpr Both NOP{0xE320F000, 0xBF00}, WFI{0xE320F003, 0xBF30}, SPIN{0xEAFFFFFE, 0xE7FE};
constexpr Both CPSIE_I{0xF1080080, 0xB662}, CPSID_I{0xF10C0080, 0xB672};
// MSR CPSR_, r1; fields c, x, s, f are bits 0 to 3.
constexpr Both msr_cpsr(unsigned fields) {
    return {0xE120F001 | fields << 16, 0xF3818000 | fields << 8};
}
// MRC and MCR of coprocessor 15.
constexpr Both mrc(const sim::Cp15& name, unsigned to = 2) {
    const std::uint32_t word =
        0xEE100F10 | name.op1 << 21 | name.crn << 16 | to << 12 | name.op2 << 5 | name.crm;
    return {word, word};
}
constexpr Both mcr(const sim::Cp15& name, unsigned from = 1) {
    const std::uint32_t word = mrc(name, from).arm & ~(1u << 20);
    return {word, word};
}

// In Thumb or not; in single steps or not.
class SystemTest : public ::testing::TestWithParam<std::tuple<bool, bool>> {
protected:
    SystemTest() { become(SVC); }

    bool thumb() const { return std::get<0>(GetParam()); }
    bool stepping() const { return std::get<1>(GetParam()); }
    // The mode, and what else of the CPSR, in this test's instruction set.
    void become(std::uint32_t cpsr) { bench.core.set_cpsr(cpsr | (thumb() ? T : 0)); }
    std::uint32_t cpsr() const { return bench.core.cpsr() & ~T; }
    std::uint32_t mode() const { return bench.core.cpsr() & MODE; }
    std::uint32_t reg(unsigned number) const { return bench.core.reg(number); }
    void set(unsigned number, std::uint32_t value) { bench.core.set_reg(number, value); }

    // In this test's set.  Returns where they end.
    std::uint32_t put(std::uint32_t at, const std::vector<Both>& instructions) {
        for (const auto& [arm, in_thumb] : instructions) {
            const auto half = static_cast<std::uint16_t>(in_thumb);
            if (!thumb())
                bench.put(at, {arm});
            else if (in_thumb > 0xFFFF)
                bench.put_halves(at, {static_cast<std::uint16_t>(in_thumb >> 16), half});
            else
                bench.put_halves(at, {half});
            at += thumb() && in_thumb <= 0xFFFF ? 2 : 4;
        }
        return at;
    }
    // One, and WFI.
    void put(Both instruction) { put(AT, {instruction, WFI, SPIN}); }
    // It, and the WFI after it or at its target.
    sim::ArmStop execute(Both instruction) {
        put(instruction);
        bench.core.set_reg(15, AT);
        return run();
    }
    void done(Both instruction) {
        const std::uint64_t before = bench.core.instructions();
        ASSERT_EQ(execute(instruction), sim::ArmStop::WFI);
        ASSERT_EQ(bench.core.instructions() - before, 2u);
    }
    void refused(Both instruction) {
        const std::uint64_t before = bench.core.instructions();
        const std::uint32_t cpsr = bench.core.cpsr();
        ASSERT_EQ(execute(instruction), sim::ArmStop::UNDEFINED) << std::hex << instruction.arm;
        ASSERT_EQ(bench.core.pc(), AT);
        ASSERT_EQ(bench.core.cpsr(), cpsr);
        ASSERT_EQ(bench.core.instructions() - before, 1u);
    }
    sim::ArmStop run() {
        if (!stepping()) return bench.core.run(1000);
        for (unsigned i = 0; i < 1000; ++i)
            if (const auto stop = bench.core.run(1); stop != sim::ArmStop::LIMIT) return stop;
        return sim::ArmStop::LIMIT;
    }

    Bench bench;
};

inline const auto EACH_WAY = ::testing::Combine(::testing::Bool(), ::testing::Bool());
inline std::string name_of_way(const ::testing::TestParamInfo<std::tuple<bool, bool>>& given) {
    return std::string{std::get<0>(given.param) ? "Thumb" : "Arm"} +
           (std::get<1>(given.param) ? "Stepping" : "");
}

}  // namespace tb::core
