// translation_bench.h - the processor with translation tables.
//
//   0x00000000  1 MB, itself: the tests' code, for all modes
//   elsewhere   what the test puts there
#pragma once

#include "tb/sim/arm_core/system_bench.h"

namespace tb::core {

constexpr std::uint32_t TABLE = 0x10000, SECOND_LEVEL = 0x14000, OTHER_TABLE = 0x18000;

// ---- Descriptors (ARM ARM, B3.5.1) ----

constexpr std::uint32_t NORMAL = 0xC;  // C and B: write-back
// AP[2:0]
constexpr unsigned NO_ACCESS = 0, PRIVILEGED_ALONE = 1, USER_READS = 2, FULL = 3,
                   PRIVILEGED_READS = 5, ALL_READ = 7;
constexpr std::uint32_t section(std::uint32_t physical, unsigned ap, unsigned domain = 0,
                                bool never = false) {
    return physical | NORMAL | 2 | (ap & 3) << 10 | (ap & 4) << 13 | domain << 5 |
           unsigned{never} << 4;
}
constexpr std::uint32_t SUPERSECTION = 1u << 18;
constexpr std::uint32_t table(std::uint32_t second_level, unsigned domain = 0) {
    return second_level | 1 | domain << 5;
}
constexpr std::uint32_t small_page(std::uint32_t physical, unsigned ap, bool never = false) {
    return physical | NORMAL | 2 | (ap & 3) << 4 | (ap & 4) << 7 | unsigned{never};
}
constexpr std::uint32_t large_page(std::uint32_t physical, unsigned ap, bool never = false) {
    return physical | NORMAL | 1 | (ap & 3) << 4 | (ap & 4) << 7 | unsigned{never} << 15;
}

// Status of DFSR and IFSR (B3.13.3); + 2: of a page.  The domain is in 7:4.
constexpr std::uint32_t TRANSLATION = 5, ACCESS_FLAG_SECTION = 3, ACCESS_FLAG_PAGE = 6, DOMAIN = 9,
                        PERMISSION = 13, OF_PAGE = 2, WALK_1 = 0xC, WALK_2 = 0xE;
constexpr std::uint32_t in_domain(unsigned domain) { return domain << 4; }

constexpr sim::Cp15 TLBIALL{8, 0, 7, 0}, TLBIMVA{8, 0, 7, 1};
constexpr Both LDR{0xE5912000, 0x680A}, STR{0xE5812000, 0x600A};  // r2, [r1]
constexpr std::uint32_t CLIENTS = 0x55555555, SCTLR_M = 1, SCTLR_AFE = 1u << 29;

class TranslationTest : public SystemTest {
protected:
    TranslationTest() {
        map(0, section(0, FULL));
        write(sim::cp15::TTBR0, TABLE);
        write(sim::cp15::DACR, CLIENTS);
        write(sim::cp15::SCTLR, SCTLR_M);
    }
    void write(const sim::Cp15& name, std::uint32_t value) {
        set(1, value);
        done(mcr(name));
    }
    // The descriptor of the megabyte, or the page of SECOND_LEVEL, at `address`.
    void map(std::uint32_t address, std::uint32_t descriptor) {
        bench.put(TABLE + (address >> 20) * 4, {descriptor});
    }
    void map_page(std::uint32_t address, std::uint32_t descriptor) {
        bench.put(SECOND_LEVEL + (address >> 12 & 0xFF) * 4, {descriptor});
    }
    void forget() { write(TLBIALL, 0); }

    std::uint32_t load(std::uint32_t address) {
        set(1, address);
        done(LDR);
        return reg(2);
    }
    void store(std::uint32_t address, std::uint32_t value) {
        set(1, address);
        set(2, value);
        done(STR);
    }
    bool goes(Both access, std::uint32_t address) {
        set(1, address);
        return execute(access) == sim::ArmStop::WFI;
    }
    void expect_refused(Both access, std::uint32_t address, std::uint32_t status) {
        set(1, address);
        set(2, 0x2222);
        const std::uint64_t before = bench.core.instructions();
        EXPECT_EQ(execute(access), sim::ArmStop::DATA_ABORT);
        EXPECT_EQ(bench.core.instructions() - before, 1u);
        EXPECT_EQ(bench.core.pc(), AT);
        EXPECT_EQ(reg(2), 0x2222u);
        EXPECT_EQ(bench.core.fault().address, address);
        EXPECT_EQ(bench.core.fault().write, !(access.arm >> 20 & 1));
        EXPECT_TRUE(bench.core.fault().mmu);
        EXPECT_EQ(bench.core.fault().status, status);
    }
};

}  // namespace tb::core
