// Data at translated addresses: rights and faults (ARM ARM, B3.5 - B3.13).  Where tables lead to is
// compared with Unicorn's.
#include <gmock/gmock.h>

#include "tb/sim/arm_core/translation_bench.h"

namespace translation {

using namespace tb::core;

constexpr std::uint32_t SECTION = 0x00200000, PAGES = 0x00300000;  // virtual
constexpr std::uint32_t PHYSICAL = 0x40000;
constexpr Both LDRT{0xE4B12000, 0xF8512E00}, STRT{0xE4A12000, 0xF8412E00};  // r2, [r1]

class Translation : public TranslationTest {
protected:
    void SetUp() override {
        bench.put(PHYSICAL, {0x1111, 0x2222, 0x3333});
        map(SECTION, section(0, FULL));
        map(PAGES, table(SECOND_LEVEL));
    }
};

// ---- Where the memory is ------------------------------------------------------------------------

TEST_P(Translation, LeadsLoadsAndStoresToRam) {
    for (unsigned i = 0; i < 16; ++i)
        map_page(PAGES + 0x20000 + (i << 12), large_page(PHYSICAL, FULL));
    map_page(PAGES + 0x5000, small_page(PHYSICAL + 0x3000, FULL));
    const std::pair<std::uint32_t, std::uint32_t> places[] = {
        {SECTION + PHYSICAL + 4, PHYSICAL + 4},
        {PAGES + 0x23008, PHYSICAL + 0x3008},
        {PAGES + 0x5FFC, PHYSICAL + 0x3FFC},
    };
    for (const auto& [address, physical] : places) {
        bench.put(physical, {address});
        EXPECT_EQ(load(address), address);
        store(address, physical);
        EXPECT_EQ(bench.word(physical), physical);
    }
}

// The second megabyte of 16 is the bus.
TEST_P(Translation, LeadsLoadsAndStoresToTheBus) {
    for (unsigned i = 0; i < 16; ++i) map(0x01000000 + (i << 20), section(0, FULL) | SUPERSECTION);
    map_page(PAGES, small_page(BUS, FULL));
    for (const std::uint32_t address : {0x01000000 + BUS + 0x20, PAGES + 0x20}) {
        store(address, 44);
        EXPECT_EQ(bench.accesses.back().address, BUS + 0x20);
        const std::uint32_t loaded = load(address);
        EXPECT_EQ(loaded, bench.accesses.back().value);
    }
    EXPECT_EQ(bench.accesses.size(), 4u);
}

// B3.13.5: DFAR has the address that the program used.
TEST_P(Translation, ReportsTheVirtualAddressThatTheBusRefused) {
    map_page(PAGES, small_page(REFUSED, FULL));
    for (const Both access : {LDR, STR}) {
        set(1, PAGES + 0x20);
        EXPECT_EQ(execute(access), sim::ArmStop::DATA_ABORT);
        EXPECT_FALSE(bench.core.fault().mmu);
        EXPECT_EQ(bench.core.fault().address, PAGES + 0x20);
    }
}

// ---- B3.13.3: faults ----------------------------------------------------------------------------

// TTBCR.PD0: no walk.
TEST_P(Translation, DoesNotWalkATableThatIsSwitchedOff) {
    set(1, 1u << 4);
    execute(mcr(sim::cp15::TTBCR));  // the table after it is no longer used
    EXPECT_EQ(run(), sim::ArmStop::PREFETCH_ABORT);
    EXPECT_TRUE(bench.core.fault().mmu);
    EXPECT_EQ(bench.core.fault().status, TRANSLATION);
}

TEST_P(Translation, FailsInAWalkWhereNoTableIs) {
    write(sim::cp15::TTBR1, 0x40000000);
    write(sim::cp15::TTBCR, 1);
    expect_refused(LDR, 0x80000000, WALK_1);
    map(0x00500000, table(0x40000000, 3));
    expect_refused(STR, 0x00500000, WALK_2 | in_domain(3));
}

// In their order of priority: without a descriptor, without the access flag, in a domain without
// access, without permission.
TEST_P(Translation, FailsForTheFirstOfAllReasons) {
    constexpr unsigned NO_FLAG = 0, READ_ONLY = 7, IN_3 = in_domain(3);
    const struct {
        std::uint32_t section, page, rights, of_section, of_page;
    } rows[] = {
        {3, 0, 0, TRANSLATION, TRANSLATION | OF_PAGE | IN_3},
        {section(0, NO_FLAG, 3), small_page(0, NO_FLAG), 0, ACCESS_FLAG_SECTION | IN_3,
         ACCESS_FLAG_PAGE | IN_3},
        {section(0, NO_FLAG, 3), small_page(0, NO_FLAG), 3, ACCESS_FLAG_SECTION | IN_3,
         ACCESS_FLAG_PAGE | IN_3},
        {section(0, READ_ONLY, 3), small_page(0, READ_ONLY), 0, DOMAIN | IN_3,
         DOMAIN | OF_PAGE | IN_3},
        {section(0, READ_ONLY, 3), small_page(0, READ_ONLY), 2, DOMAIN | IN_3,
         DOMAIN | OF_PAGE | IN_3},
        {section(0, READ_ONLY, 3), small_page(0, READ_ONLY), 1, PERMISSION | IN_3,
         PERMISSION | OF_PAGE | IN_3},
    };
    write(sim::cp15::SCTLR, SCTLR_M | SCTLR_AFE);
    map(PAGES, table(SECOND_LEVEL, 3));
    for (const auto& row : rows) {
        map(SECTION, row.section);
        map_page(PAGES, row.page);
        write(sim::cp15::DACR, 1 | row.rights << 6);
        for (const Both access : {LDR, STR}) {
            if (row.rights == 1 && access.arm == LDR.arm) continue;
            expect_refused(access, SECTION, row.of_section);
            expect_refused(access, PAGES, row.of_page);
        }
    }
}

// B3.7.1; with one mode after the other, so that no right is kept.
TEST_P(Translation, AllowsWhatTheModeMayDo) {
    const struct {
        unsigned ap;
        bool privileged_writes, user_reads, user_writes;
    } rows[] = {
        {PRIVILEGED_ALONE, true, false, false},
        {USER_READS, true, true, false},
        {FULL, true, true, true},
        {ALL_READ, false, true, false},
    };
    for (const auto& row : rows) {
        SCOPED_TRACE(row.ap);
        map_page(PAGES, small_page(PHYSICAL, row.ap));
        forget();
        const auto expect = [&](Both access, bool allowed) {
            if (allowed)
                EXPECT_TRUE(goes(access, PAGES));
            else
                expect_refused(access, PAGES, PERMISSION | OF_PAGE);
        };
        for (const std::uint32_t mode : {SVC, USR, SYS, USR, SVC}) {
            become(mode);
            for (unsigned again = 0; again < 2; ++again) {
                expect(LDR, mode != USR || row.user_reads);
                expect(STR, mode == USR ? row.user_writes : row.privileged_writes);
                expect(LDRT, row.user_reads);  // A4.6.3: the user mode's rights
                expect(STRT, row.user_writes);
            }
        }
    }
}

// ---- B4.1.112, B4.2.4: what a program learns of the tables --------------------------------------

TEST_P(Translation, IsWrittenToTheParForAProgramThatAsks) {
    constexpr sim::Cp15 READS{7, 0, 8, 0}, WRITES{7, 0, 8, 1}, USER_READS_{7, 0, 8, 2};
    constexpr std::uint32_t WRITE_BACK = 0x7C, SHAREABLE = 1u << 16, FAULT = 1;
    const auto par = [this](const sim::Cp15& operation, std::uint32_t address) {
        write(operation, address);
        done(mrc(sim::cp15::PAR));
        return reg(2);
    };
    map(SECTION, section(0x00700000, PRIVILEGED_READS) | SHAREABLE);
    EXPECT_EQ(par(READS, SECTION + 0x12345), 0x00712080u | WRITE_BACK);
    EXPECT_EQ(par(WRITES, SECTION), FAULT | PERMISSION << 1);
    EXPECT_EQ(par(USER_READS_, SECTION), FAULT | PERMISSION << 1);
    map_page(PAGES + 0x5000, 0x00040000 | 0x32);  // Strongly-ordered
    EXPECT_EQ(par(WRITES, PAGES + 0x5678), 0x00040010u);
    EXPECT_EQ(par(READS, PAGES + 0x6000), FAULT | (TRANSLATION + OF_PAGE) << 1);
    for (unsigned i = 0; i < 16; ++i)
        map(0x01000000 + (i << 20), section(0x02000000, FULL) | SUPERSECTION);
    EXPECT_EQ(par(READS, 0x01234567), 0x02000002u | WRITE_BACK);
    write(sim::cp15::SCTLR, 0);
    EXPECT_EQ(par(WRITES, 0x12345678), 0x12345010u) << "the MMU is off";
    become(USR);
    refused(mcr(READS));
}

INSTANTIATE_TEST_SUITE_P(In, Translation, EACH_WAY, name_of_way);

}  // namespace translation
