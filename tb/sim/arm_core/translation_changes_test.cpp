// Translation tables that change, accesses across the border of two pages, and code at translated
// addresses (ARM ARM, B3.7.2, B3.9 - B3.10).
#include <gmock/gmock.h>

#include "tb/sim/arm_core/translation_bench.h"

namespace translation_changes {

using namespace tb::core;
using sim::ArmStop;

constexpr std::uint32_t SECTION = 0x00200000, PAGES = 0x00300000;  // virtual
constexpr std::uint32_t ONE = 0x40000, OTHER = 0x50000;            // physical
constexpr std::uint32_t PLACE = PAGES + 0x17000;

class TranslationChanges : public TranslationTest {
protected:
    void SetUp() override {
        bench.put(ONE, {0x1111, 0x1112});
        bench.put(OTHER, {0x2222, 0x2223});
        map(SECTION, section(0, FULL));
        map(PAGES, table(SECOND_LEVEL));
        map_page(PLACE, small_page(ONE, FULL));
    }
};

// ---- Entries that change (B3.9) -----------------------------------------------------------------

TEST_P(TranslationChanges, AreSeenAfterEachOperation) {
    const std::pair<sim::Cp15, std::uint32_t> operations[] = {
        {TLBIALL, 0},
        {TLBIMVA, PLACE},
        {{8, 0, 7, 2}, 0},           // TLBIASID
        {{8, 0, 7, 3}, PLACE},       // TLBIMVAA
        {sim::cp15::CONTEXTIDR, 7},  // another ASID
    };
    std::uint32_t before = ONE, after = OTHER;
    for (const auto& [operation, value] : operations) {
        store(PLACE + 8, 5);
        map_page(PLACE, small_page(after, FULL));
        write(operation, value);
        EXPECT_EQ(load(PLACE), bench.word(after)) << operation.crn << operation.op2;
        store(PLACE + 8, 6);
        EXPECT_EQ(bench.word(before + 8), 5u);
        EXPECT_EQ(bench.word(after + 8), 6u);
        std::swap(before, after);
    }
}

TEST_P(TranslationChanges, AreSeenWithAnotherTable) {
    bench.put(OTHER_TABLE, {section(0, FULL)});
    bench.put(OTHER_TABLE + (PAGES >> 20) * 4, {table(SECOND_LEVEL + 0x400)});
    bench.put(SECOND_LEVEL + 0x400 + (PLACE >> 12 & 0xFF) * 4, {small_page(OTHER, FULL)});
    EXPECT_EQ(load(PLACE), 0x1111u);
    write(sim::cp15::TTBR0, OTHER_TABLE);
    EXPECT_EQ(load(PLACE), 0x2222u);
    write(sim::cp15::SCTLR, 0);
    bench.put(0x20000, {0x3333});
    EXPECT_EQ(load(0x20000), 0x3333u) << "without the tables";
}

// B3.9.1: what has failed for want of a descriptor or of the access flag is in no TLB.
TEST_P(TranslationChanges, OfWhatHasFailedNeedNoInvalidation) {
    write(sim::cp15::SCTLR, SCTLR_M | SCTLR_AFE);
    const struct {
        std::uint32_t before, status;
    } entries[] = {{0, TRANSLATION | OF_PAGE}, {small_page(ONE, 2), ACCESS_FLAG_PAGE}};
    for (const auto& entry : entries) {
        map_page(PLACE, entry.before);
        forget();
        expect_refused(LDR, PLACE, entry.status);
        expect_refused(STR, PLACE, entry.status);
        map_page(PLACE, small_page(OTHER, FULL));
        EXPECT_TRUE(goes(LDR, PLACE));
        EXPECT_EQ(reg(2), 0x2222u);
    }
}

// ---- Over the border of two pages ---------------------------------------------------------------

TEST_P(TranslationChanges, DoNotMixUpTheHalvesOfAnAccess) {
    map_page(PLACE + 0x1000, small_page(OTHER, FULL));
    bench.put(ONE + 0xFFC, {0xAABBCCDD});
    bench.put(OTHER, {0x11223344});
    EXPECT_EQ(load(PLACE + 0xFFE), 0x3344AABBu);
    EXPECT_EQ(load(PLACE + 0xFFD), 0x44AABBCCu);
    store(PLACE + 0xFFF, 0x55667788);
    EXPECT_EQ(bench.word(ONE + 0xFFC), 0x88BBCCDDu);
    EXPECT_EQ(bench.word(OTHER), 0x11556677u);
}

TEST_P(TranslationChanges, FailWhereTheSecondPageDoes) {
    for (const std::uint32_t second : {0u, small_page(OTHER, PRIVILEGED_READS)}) {
        map_page(PLACE + 0x1000, second);
        forget();
        for (unsigned offset = 0xFFD; offset <= 0xFFF; ++offset)
            for (const Both access : {LDR, STR}) {
                if (access.arm == LDR.arm && second) continue;
                set(1, PLACE + offset);
                set(2, 0x2222);
                EXPECT_EQ(execute(access), ArmStop::DATA_ABORT);
                EXPECT_EQ(bench.core.fault().address, PLACE + 0x1000) << offset;
                EXPECT_EQ(bench.core.fault().status, (second ? PERMISSION : TRANSLATION) | OF_PAGE);
                EXPECT_EQ(reg(1), PLACE + offset);
                EXPECT_EQ(reg(2), 0x2222u);
            }
    }
}

// ---- Code ---------------------------------------------------------------------------------------

class TranslatedCode : public TranslationChanges {
protected:
    static constexpr Both ADD_1{0xE2800001, 0x3001}, ADD_16{0xE2800010, 0x3010};  // r0, of ADDS
    void put(std::uint32_t physical, Both instruction) {
        SystemTest::put(physical, {instruction, WFI, SPIN});
    }
    ArmStop run_at(std::uint32_t address) {
        set(0, 0);
        set(15, address);
        return run();
    }
    void expect_refused_at(std::uint32_t address, std::uint32_t status) {
        const std::uint64_t before = bench.core.instructions();
        EXPECT_EQ(run_at(address), ArmStop::PREFETCH_ABORT);
        EXPECT_EQ(bench.core.instructions(), before);
        EXPECT_EQ(bench.core.pc(), address);
        EXPECT_EQ(bench.core.fault().address, address);
        EXPECT_TRUE(bench.core.fault().mmu);
        EXPECT_EQ(bench.core.fault().status, status);
    }
};

TEST_P(TranslatedCode, IsThatOfTheNewPage) {
    put(ONE, ADD_1);
    put(OTHER, ADD_16);
    EXPECT_EQ(run_at(PLACE), ArmStop::WFI);
    EXPECT_EQ(reg(0), 1u);
    map_page(PLACE, small_page(OTHER, FULL));
    forget();
    EXPECT_EQ(run_at(PLACE), ArmStop::WFI);
    EXPECT_EQ(reg(0), 16u);
}

TEST_P(TranslatedCode, IsNewWhenItIsWrittenByAnotherAddress) {
    put(ONE, ADD_1);
    for (const unsigned number : {1, 16, 1}) {
        store(SECTION + ONE, thumb() ? 0xBF303000 | number : 0xE2800000 | number);
        EXPECT_EQ(run_at(PLACE), ArmStop::WFI);
        EXPECT_EQ(reg(0), number);
    }
}

// B3.7.2
TEST_P(TranslatedCode, IsRefusedWhereItMustNeverBeExecuted) {
    put(ONE, ADD_1);
    map(SECTION, section(0, FULL, 2, true));
    map(PAGES, table(SECOND_LEVEL, 2));
    map_page(PLACE, small_page(ONE, FULL, true));
    map_page(PAGES, large_page(ONE, FULL, true));
    forget();
    expect_refused_at(SECTION + ONE, PERMISSION | in_domain(2));
    expect_refused_at(PLACE, PERMISSION | OF_PAGE | in_domain(2));
    expect_refused_at(PAGES, PERMISSION | OF_PAGE | in_domain(2));
    expect_refused_at(PAGES + 0x4000, TRANSLATION | OF_PAGE | in_domain(2));
    expect_refused_at(0x00400000, TRANSLATION);
    map_page(PAGES, large_page(ONE, FULL));
    forget();
    EXPECT_EQ(run_at(PAGES), ArmStop::WFI);
    write(sim::cp15::DACR, 1 | 3 << 4);
    EXPECT_EQ(run_at(PLACE), ArmStop::WFI) << "a manager's";
}

// Executed before by the one who may.
TEST_P(TranslatedCode, IsRefusedToTheUserWhereHeMayNotRead) {
    put(ONE, ADD_1);
    for (const unsigned ap : {PRIVILEGED_ALONE, PRIVILEGED_READS}) {
        map_page(PLACE, small_page(ONE, ap));
        forget();
        for (unsigned i = 0; i < 2; ++i) {
            become(SVC);
            EXPECT_EQ(run_at(PLACE), ArmStop::WFI);
            become(USR);
            expect_refused_at(PLACE, PERMISSION | OF_PAGE);
        }
        become(SVC);
    }
    map_page(PLACE, small_page(ONE, ALL_READ));
    forget();
    become(USR);
    EXPECT_EQ(run_at(PLACE), ArmStop::WFI);
}

TEST_P(TranslatedCode, NeedsNoInvalidationWhereThereWasNone) {
    put(ONE, ADD_1);
    map_page(PLACE, 0);
    forget();
    expect_refused_at(PLACE, TRANSLATION | OF_PAGE);
    map_page(PLACE, small_page(ONE, FULL));
    EXPECT_EQ(run_at(PLACE), ArmStop::WFI);
}

// The bus refuses it, not the tables, whatever else they refuse.
TEST_P(TranslatedCode, IsRefusedByTheBusInAPageOfData) {
    map_page(PLACE, small_page(BUS, ALL_READ));
    EXPECT_EQ(run_at(PLACE), ArmStop::PREFETCH_ABORT);
    EXPECT_FALSE(bench.core.fault().mmu);
}

// B3.13.5: an instruction of two pages fails where its second half is.
TEST_P(TranslatedCode, FailsWhereTheSecondHalfOfAnInstructionIs) {
    if (!thumb()) return;
    map_page(PLACE + 0x1000, 0);
    bench.put_halves(ONE + 0xFFC, {0xBF00, 0xF100});  // NOP; ADD.W r0, r0, #16
    bench.put_halves(OTHER, {0x0010, 0xBF30, 0xE7FE});
    EXPECT_EQ(run_at(PLACE + 0xFFC), ArmStop::PREFETCH_ABORT);
    EXPECT_EQ(bench.core.pc(), PLACE + 0xFFE);
    EXPECT_EQ(bench.core.fault().address, PLACE + 0x1000);
    map_page(PLACE + 0x1000, small_page(OTHER, FULL));
    EXPECT_EQ(run(), ArmStop::WFI);
    EXPECT_EQ(reg(0), 16u);
}

INSTANTIATE_TEST_SUITE_P(In, TranslationChanges, EACH_WAY, name_of_way);
INSTANTIATE_TEST_SUITE_P(In, TranslatedCode, EACH_WAY, name_of_way);

}  // namespace translation_changes
