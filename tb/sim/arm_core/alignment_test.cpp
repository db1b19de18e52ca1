// Unaligned loads and stores abort as ARM DDI 0406C, A3.2.1 says: some always, all others with
// SCTLR.A, and in memory that is not Normal, as all is with the MMU off.
//
// All of those that abort always but the exclusive ones, and what others do in Normal memory, are
// compared with QEMU's.
#include <gmock/gmock.h>

#include "tb/sim/arm_core/system_bench.h"

namespace alignment {

using namespace tb::core;

constexpr std::uint32_t TABLE = 0x4000, DATA = 0x80000;
constexpr std::uint32_t NORMAL_SECTION = 0x1C0E, DEVICE_SECTION = 0xC06;  // full access
constexpr std::uint32_t M = 1, STRICT = 2;                                // SCTLR.M and A
constexpr std::uint32_t ALIGNMENT_FAULT = 1;

struct Access {
    const char* name;
    Both words;  // at r1
    std::uint32_t bytes;
    bool always, write;
};
constexpr Access ACCESSES[] = {
    {"LDR", {0xE5912000, 0x680A}, 4, false, false},
    {"LDR.W with write-back", {0xE4912004, 0xF8512B04}, 4, false, false},
    {"STR", {0xE5812000, 0x600A}, 4, false, true},
    {"LDRH", {0xE1D120B0, 0x880A}, 2, false, false},
    {"LDRSH", {0xE1D120F0, 0xF9B12000}, 2, false, false},
    {"STRH", {0xE1C120B0, 0x800A}, 2, false, true},
    {"LDRB", {0xE5D12000, 0x780A}, 1, false, false},
    {"STRB", {0xE5C12000, 0x700A}, 1, false, true},
    {"LDM", {0xE891000C, 0xE891000C}, 4, true, false},
    {"STM with write-back", {0xE8A1000C, 0xE8A1000C}, 4, true, true},
    {"LDRD", {0xE1C120D0, 0xE9D12300}, 4, true, false},
    {"STRD", {0xE1C120F0, 0xE9C12300}, 4, true, true},
    {"LDREX", {0xE1912F9F, 0xE8512F00}, 4, true, false},
    {"LDREXH", {0xE1F12F9F, 0xE8D12F5F}, 2, true, false},
    {"LDREXB", {0xE1D12F9F, 0xE8D12F4F}, 1, true, false},
    {"LDREXD", {0xE1B12F9F, 0xE8D1237F}, 8, true, false},
    {"VLDR", {0xED910B00, 0xED910B00}, 4, true, false},
    {"VSTR", {0xED810B00, 0xED810B00}, 4, true, true},
    {"VLD1.8", {0xF421070F, 0xF921070F}, 1, false, false},
    {"VLD1.16", {0xF421074F, 0xF921074F}, 2, false, false},
    {"VLD1.32", {0xF421078D, 0xF921078D}, 4, false, false},
    {"VLD1.64", {0xF42107CF, 0xF92107CF}, 8, false, false},
    {"VST1.64", {0xF40107CF, 0xF90107CF}, 8, false, true},
    {"VLD1.8 :256", {0xF421023F, 0xF921023F}, 32, true, false},
    {"VLD4.16 :256", {0xF421007F, 0xF921007F}, 32, true, false},
    {"VST3.32", {0xF401048F, 0xF901048F}, 4, false, true},
    {"VLD1.16 lane", {0xF4A1040F, 0xF9A1040F}, 2, false, false},
};
constexpr Access PRIVILEGED[] = {
    {"LDM of user registers", {0xE8D1000C, 0}, 4, true, false},
    {"STM of user registers", {0xE8C1000C, 0}, 4, true, true},
    {"RFE", {0xF8910A00, 0xE991C000}, 4, true, false},
};

class Alignment : public SystemTest {
protected:
    Alignment() {
        bench.core.unmap(0, RAM);
        bench.core.map_ram(0, RAM, bench.memory());  // Normal by the translation tables alone
        bench.core.set_cp15(sim::cp15::TTBR0, TABLE);
        bench.core.set_cp15(sim::cp15::DACR, 1);
    }
    // `first`: the descriptor of the memory.
    void control(std::uint32_t sctlr, std::uint32_t first = NORMAL_SECTION) {
        bench.put(TABLE, {first});
        bench.core.set_cp15(sim::cp15::SCTLR, sctlr);
        set(1, 0);
        done({0xEE081F17, 0xEE081F17});  // TLBIALL
    }
    void expect_abort(const Access& a, std::uint32_t address, bool aborts) {
        SCOPED_TRACE(testing::Message() << a.name << " at +" << address - DATA);
        if (thumb() && a.words.thumb == 0) return;
        become(SVC);
        for (unsigned i = 1; i < 4; ++i) set(i, i == 1 ? address : 0xAAAAAAA0 + i);
        const sim::ArmStop stop = execute(a.words);
        ASSERT_EQ(stop == sim::ArmStop::DATA_ABORT, aborts);
        if (!aborts) return;
        EXPECT_EQ(bench.core.pc(), AT);
        EXPECT_EQ(bench.core.fault().status, ALIGNMENT_FAULT);
        EXPECT_EQ(bench.core.fault().address, address);
        EXPECT_EQ(bench.core.fault().write, a.write);
        EXPECT_EQ(reg(1), address);
        EXPECT_EQ(reg(2), 0xAAAAAAA2);
        EXPECT_EQ(reg(3), 0xAAAAAAA3);
    }
};

TEST_P(Alignment, IsNeededByFewInNormalMemoryAndElsewhereByAll) {
    const struct {
        std::uint32_t sctlr, first;
        bool strict;  // for all, not only those that abort always
    } ways[] = {
        {0, NORMAL_SECTION, true},
        {M, NORMAL_SECTION, false},
        {M | STRICT, NORMAL_SECTION, true},
        {M, DEVICE_SECTION, true},
    };
    for (const auto& way : ways) {
        control(way.sctlr, way.first);
        for (const Access& a : ACCESSES)
            for (std::uint32_t offset = 0; offset < 32; ++offset)
                expect_abort(a, DATA + offset, offset % a.bytes != 0 && (way.strict || a.always));
    }
}

TEST_P(Alignment, IsNeededByLoadsAndStoresOfPrivilegedModes) {
    for (const std::uint32_t sctlr : {0u, M}) {
        control(sctlr);
        for (const Access& a : PRIVILEGED)
            for (std::uint32_t offset = 1; offset < 4; ++offset)
                expect_abort(a, DATA + offset, true);
    }
}

// A loop that was translated while the address was right.
TEST_P(Alignment, IsNeededByCodeThatHasRunLong) {
    if (thumb()) return;
    for (const Access& a : ACCESSES) {
        if (a.bytes == 1) continue;
        SCOPED_TRACE(a.name);
        bench.put(AT, {
                          0xE1A01004,   // MOV r1, r4
                          a.words.arm,  //
                          0xE2555001,   // SUBS r5, r5, #1
                          0x02844001,   // ADDEQ r4, r4, #1
                          0xEAFFFFFA,   // B to the begin
                      });
        become(SVC);
        set(4, DATA);
        set(5, 100);
        set(15, AT);
        ASSERT_EQ(run(), sim::ArmStop::DATA_ABORT);
        EXPECT_EQ(bench.core.pc(), AT + 4);
        EXPECT_EQ(bench.core.fault().address, DATA + 1);
        EXPECT_EQ(reg(5), 0u);
    }
}

TEST_P(Alignment, IsNeededAtTheBus) {
    const auto before = bench.accesses.size();
    expect_abort(ACCESSES[0], BUS + 2, true);
    expect_abort(ACCESSES[2], BUS + 1, true);
    EXPECT_EQ(bench.accesses.size(), before);
}

INSTANTIATE_TEST_SUITE_P(In, Alignment, EACH_WAY, name_of_way);

}  // namespace alignment
