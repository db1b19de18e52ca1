// Data at translated addresses: descriptors, domains, permissions, faults (ARM ARM,
// B3.5 - B3.13).
#include <gmock/gmock.h>

#include "tb/sim/arm_core/translation_bench.h"

namespace translation {

using namespace tb::core;

constexpr std::uint32_t SECTION = 0x00200000, PAGES = 0x00300000;  // virtual
constexpr std::uint32_t PHYSICAL = 0x40000;

class Translation : public TranslationTest {
protected:
    void SetUp() override {
        bench.put(PHYSICAL, {0x1111, 0x2222, 0x3333});
        map(SECTION, section(0, FULL));
        map(PAGES, table(SECOND_LEVEL));
    }
};

// ---- B3.5.1: descriptors ------------------------------------------------------------------------

TEST_P(Translation, FindsSections) {
    EXPECT_EQ(load(SECTION + PHYSICAL + 4), 0x2222u);
    store(SECTION + PHYSICAL + 8, 77);
    EXPECT_EQ(bench.word(PHYSICAL + 8), 77u);
}

// The second megabyte of 16 is the bus.
TEST_P(Translation, FindsSupersections) {
    for (unsigned i = 0; i < 16; ++i)
        map(0x01000000 + (i << 20), section(0, FULL, 0) | SUPERSECTION | 0xF << 5);
    EXPECT_EQ(load(0x01000000 + PHYSICAL), 0x1111u);
    store(0x01000000 + BUS + 0x10, 55);
    ASSERT_EQ(bench.accesses.size(), 1u);
    EXPECT_EQ(bench.accesses[0].address, BUS + 0x10);
    write(sim::cp15::DACR, CLIENTS & 0x3FFFFFFF);
    EXPECT_EQ(load(0x01000000 + PHYSICAL), 0x1111u) << "its domain is 0, whatever is in 8:5";
}

TEST_P(Translation, FindsSmallPages) {
    map_page(PAGES + 0x5000, small_page(PHYSICAL, FULL));
    EXPECT_EQ(load(PAGES + 0x5000), 0x1111u);
    store(PAGES + 0x5FFC, 66);
    EXPECT_EQ(bench.word(PHYSICAL + 0xFFC), 66u);
}

TEST_P(Translation, FindsLargePages) {
    for (unsigned i = 0; i < 16; ++i)
        map_page(PAGES + 0x20000 + (i << 12), large_page(PHYSICAL, FULL));
    EXPECT_EQ(load(PAGES + 0x20004), 0x2222u);
    store(PAGES + 0x2FFFC, 88);
    EXPECT_EQ(bench.word(PHYSICAL + 0xFFFC), 88u);
}

TEST_P(Translation, ReachesTheBus) {
    map_page(PAGES, small_page(BUS, FULL));
    store(PAGES + 0x20, 44);
    ASSERT_EQ(bench.accesses.size(), 1u);
    EXPECT_EQ(bench.accesses[0].address, BUS + 0x20);
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

// ---- B3.5.4: two tables -------------------------------------------------------------------------

TEST_P(Translation, TakesHighAddressesFromTheSecondTable) {
    bench.put(OTHER_TABLE + 0x802 * 4, {section(0, FULL)});
    write(sim::cp15::TTBR1, OTHER_TABLE);
    write(sim::cp15::TTBCR, 1);
    EXPECT_EQ(load(0x80200000 + PHYSICAL), 0x1111u);
    EXPECT_EQ(load(SECTION + PHYSICAL), 0x1111u);
    expect_refused(LDR, 0x80300000, TRANSLATION);
}

// TTBCR.PD0 and PD1: no walk.
TEST_P(Translation, DoesNotWalkATableThatIsSwitchedOff) {
    bench.put(OTHER_TABLE + 0x802 * 4, {section(0, FULL)});
    write(sim::cp15::TTBR1, OTHER_TABLE);
    write(sim::cp15::TTBCR, 1 | 1u << 5);
    EXPECT_EQ(load(SECTION + PHYSICAL), 0x1111u);
    expect_refused(LDR, 0x80200000 + PHYSICAL, TRANSLATION);
    set(1, 1 | 1u << 4);
    execute(mcr(sim::cp15::TTBCR));  // the table after it is no longer used
    EXPECT_EQ(run(), sim::ArmStop::PREFETCH_ABORT);
    EXPECT_TRUE(bench.core.fault().mmu);
    EXPECT_EQ(bench.core.fault().status, TRANSLATION);
}

// ---- B3.13.3: faults, in their order of priority ------------------------------------------------

TEST_P(Translation, FailsInAWalkWhereNoTableIs) {
    write(sim::cp15::TTBR1, 0x40000000);
    write(sim::cp15::TTBCR, 1);
    expect_refused(LDR, 0x80000000, WALK_1);
    map(0x00500000, table(0x40000000, 3));
    expect_refused(STR, 0x00500000, WALK_2 | in_domain(3));
}

TEST_P(Translation, FailsWithoutADescriptor) {
    map(0x00600000, 3);
    map(0x00700000, table(SECOND_LEVEL, 4));
    for (const Both access : {LDR, STR}) {
        expect_refused(access, 0x00500000, TRANSLATION);
        expect_refused(access, 0x00600000, TRANSLATION);
        expect_refused(access, 0x00703004, TRANSLATION | OF_PAGE | in_domain(4));
    }
}

TEST_P(Translation, FailsWithoutTheAccessFlagBeforeTheDomainIsAsked) {
    write(sim::cp15::SCTLR, SCTLR_M | SCTLR_AFE);
    map(PAGES, table(SECOND_LEVEL, 3));
    for (const std::uint32_t of_domain_3 : {0u, 1u, 3u}) {
        map(SECTION, section(0, 2, 3));
        map_page(PAGES, small_page(PHYSICAL, 2));
        write(sim::cp15::DACR, 1 | of_domain_3 << 6);
        for (const Both access : {LDR, STR}) {
            expect_refused(access, SECTION, ACCESS_FLAG_SECTION | in_domain(3));
            expect_refused(access, PAGES, ACCESS_FLAG_PAGE | in_domain(3));
        }
    }
}

TEST_P(Translation, FailsInADomainWithoutAccess) {
    map(SECTION, section(0, FULL, 5));
    map(PAGES, table(SECOND_LEVEL, 6));
    map_page(PAGES, small_page(PHYSICAL, FULL));
    for (const std::uint32_t rights : {0u, 2u}) {
        write(sim::cp15::DACR, 1 | rights << 10 | rights << 12);
        for (const Both access : {LDR, STR}) {
            expect_refused(access, SECTION, DOMAIN | in_domain(5));
            expect_refused(access, PAGES, DOMAIN | OF_PAGE | in_domain(6));
        }
    }
    write(sim::cp15::DACR, 1 | 1 << 10 | 1 << 12);
    EXPECT_EQ(load(SECTION + PHYSICAL), 0x1111u);
    EXPECT_EQ(load(PAGES), 0x1111u);
}

TEST_P(Translation, AsksNoPermissionOfAManager) {
    map(SECTION, section(0, NO_ACCESS, 5));
    write(sim::cp15::DACR, 1 | 3 << 10);
    EXPECT_EQ(load(SECTION + PHYSICAL), 0x1111u);
    store(SECTION + PHYSICAL, 99);
    become(USR);
    EXPECT_EQ(load(SECTION + PHYSICAL), 99u);
}

// B3.7.1, of sections and pages; with one mode after the other, so that no right is kept.
TEST_P(Translation, AllowsWhatThePermissionsSay) {
    const struct {
        unsigned ap;
        bool privileged_reads, privileged_writes, user_reads, user_writes;
    } rows[] = {
        {NO_ACCESS, false, false, false, false},       {PRIVILEGED_ALONE, true, true, false, false},
        {USER_READS, true, true, true, false},         {FULL, true, true, true, true},
        {PRIVILEGED_READS, true, false, false, false}, {6, true, false, true, false},
        {ALL_READ, true, false, true, false},
    };
    for (const auto& row : rows) {
        SCOPED_TRACE(row.ap);
        map(SECTION, section(0, row.ap, 2));
        map(PAGES, table(SECOND_LEVEL, 2));
        map_page(PAGES, small_page(PHYSICAL, row.ap));
        map_page(PAGES + 0x10000, large_page(PHYSICAL, row.ap));
        forget();
        for (const std::uint32_t mode : {SVC, USR, SYS, USR}) {
            become(mode);
            const bool user = mode == USR;
            for (unsigned again = 0; again < 2; ++again)
                for (const std::uint32_t at : {SECTION + PHYSICAL, PAGES, PAGES + 0x10000}) {
                    const std::uint32_t status =
                        PERMISSION | in_domain(2) | (at < PAGES ? 0 : OF_PAGE);
                    if (user ? row.user_reads : row.privileged_reads)
                        EXPECT_TRUE(goes(LDR, at)) << mode;
                    else
                        expect_refused(LDR, at, status);
                    if (user ? row.user_writes : row.privileged_writes)
                        EXPECT_TRUE(goes(STR, at)) << mode;
                    else
                        expect_refused(STR, at, status);
                }
        }
        become(SVC);
    }
}

// SCTLR.AFE: AP[2:1] alone.
TEST_P(Translation, AllowsWhatTheSimplerPermissionsSay) {
    map(0, section(0, FULL));
    write(sim::cp15::SCTLR, SCTLR_M | SCTLR_AFE);
    for (const unsigned ap : {1u, 3u, 5u, 7u}) {
        map(SECTION, section(0, ap));
        forget();
        EXPECT_TRUE(goes(LDR, SECTION + PHYSICAL)) << ap;
        EXPECT_EQ(goes(STR, SECTION + PHYSICAL), ap < 4) << ap;
        become(USR);
        EXPECT_EQ(goes(LDR, SECTION + PHYSICAL), (ap & 2) != 0) << ap;
        EXPECT_EQ(goes(STR, SECTION + PHYSICAL), ap == 3) << ap;
        become(SVC);
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

INSTANTIATE_TEST_SUITE_P(In, Translation, ::testing::Combine(::testing::Bool(), ::testing::Bool()),
                         name_of_way);

}  // namespace translation
