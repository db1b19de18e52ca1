// The bus learns which stores go to Normal memory.  Types by the descriptors' TEX, C and B: ARM
// DDI 0406C, B3.8.2; with TEX remap: B3.8.3.
#include <gtest/gtest.h>

#include "tb/sim/arm_core/bench.h"

namespace memory_types {

using namespace tb::core;

constexpr std::uint32_t FIRST = 0x4000, SECOND = 0x8000, AT = 0x1000;  // tables, code
constexpr std::uint32_t SECTION = 0xC02, LARGE = 0x31, SMALL = 0x32;   // full access
constexpr std::uint32_t M = 1, TRE = 1u << 28;
constexpr sim::Cp15 PRRR{10, 0, 2, 0};

class Observed : public Bench {
public:
    unsigned normal = 0;

    bool write_normal(std::uint32_t address, unsigned bytes, std::uint32_t value) override {
        ++normal;
        return write(address, bytes, value);
    }
};

class MemoryTypes : public ::testing::Test {
protected:
    MemoryTypes() {
        // mcr p15, 0, r0, c8, c7, 0 (TLBIALL); str r1, [r0]
        bench.put(AT, {0xEE080F17, 0xE5801000});
        bench.put(FIRST, {SECTION, SECOND | 0x01});  // 1 MB of RAM; a table
        bench.core.set_cp15(sim::cp15::TTBR0, FIRST);
        bench.core.set_cp15(sim::cp15::DACR, 1);
    }

    // Whether a store through the descriptor is one to Normal memory.
    bool is_normal(std::uint32_t address) {
        bench.core.set_cp15(sim::cp15::SCTLR, control);
        bench.core.set_reg(0, address);
        bench.core.set_reg(15, AT);
        const unsigned before = bench.normal;
        const std::size_t stores = bench.accesses.size();
        EXPECT_EQ(bench.core.run(2), sim::ArmStop::LIMIT);
        EXPECT_EQ(bench.accesses.size(), stores + 1);
        return bench.normal != before;
    }
    bool section(unsigned tex, unsigned cb) {
        bench.put(FIRST + 4, {BUS | tex << 12 | cb << 2 | SECTION});
        return is_normal(BUS);
    }
    bool large_page(unsigned tex, unsigned cb) {
        bench.put(FIRST + 4, {SECOND | 1});
        bench.put(SECOND, {BUS | tex << 12 | cb << 2 | LARGE});
        return is_normal(BUS);
    }
    bool small_page(unsigned tex, unsigned cb) {
        bench.put(FIRST + 4, {SECOND | 1});
        bench.put(SECOND, {BUS | tex << 6 | cb << 2 | SMALL});
        return is_normal(BUS);
    }

    Observed bench;
    std::uint32_t control = M;
};

TEST_F(MemoryTypes, AreThoseOfTexCAndB) {
    // Rows: TEX 0 to 7; columns: CB 0 to 3.  Reserved ones are not Normal.
    const bool normal[8][4] = {
        {false, false, true, true},  // Strongly-ordered, Device, write-through, write-back
        {true, false, false, true},  // not cached, reserved, implementation defined, write-allocate
        {false, false, false, false}, {false, false, false, false}, {true, true, true, true},
        {true, true, true, true},     {true, true, true, true},     {true, true, true, true},
    };
    for (unsigned tex = 0; tex < 8; ++tex)
        for (unsigned cb = 0; cb < 4; ++cb) {
            SCOPED_TRACE(testing::Message() << "TEX " << tex << ", CB " << cb);
            EXPECT_EQ(section(tex, cb), normal[tex][cb]);
            EXPECT_EQ(large_page(tex, cb), normal[tex][cb]);
            EXPECT_EQ(small_page(tex, cb), normal[tex][cb]);
        }
}

TEST_F(MemoryTypes, AreThoseOfThePrimaryRegionRemapRegister) {
    control = M | TRE;
    // By TEX[0], C, B.  What is not Normal is Strongly-ordered or Device here.
    const bool normal[8] = {false, true, false, false, true, true, false, true};
    std::uint32_t types = 0;
    for (unsigned i = 0; i < 8; ++i) types |= (normal[i] ? 2u : i % 2) << (2 * i);
    bench.core.set_cp15(PRRR, types);
    for (unsigned i = 0; i < 8; ++i) EXPECT_EQ(section(i >> 2 | 6, i & 3), normal[i]) << i;
}

TEST_F(MemoryTypes, AreNotNormalWithTheMmuOff) {
    control = 0;
    EXPECT_FALSE(is_normal(BUS));
}

}  // namespace memory_types
