// LDRT, STRT and their kind have the user mode's rights (ARM DDI 0406C, A4.6.3); SWP is an
// instruction where SCTLR.SW says so (A8.8.229).
#include <gmock/gmock.h>

#include "tb/sim/arm_core/translation_bench.h"

namespace user_rights {

using namespace tb::core;

constexpr std::uint32_t PLACE = 0x100000, HERE = 0x20000;  // PLACE is HERE
constexpr Both LDRT{0xE4B12000, 0xF8512E00}, STRT{0xE4A12000, 0xF8412E00};

class UserRights : public TranslationTest {
protected:
    UserRights() {
        bench.put(TABLE + 4, {table(SECOND_LEVEL)});
        bench.put(HERE, {0x8182F3F4});
    }
    void give(unsigned ap) {
        map_page(PLACE, small_page(HERE, ap));
        forget();
    }
};

TEST_P(UserRights, AreThoseOfLdrtAndStrt) {
    give(FULL);
    set(1, PLACE);
    done(LDRT);
    EXPECT_EQ(reg(2), 0x8182F3F4u);
    give(USER_READS);
    EXPECT_TRUE(goes(LDRT, PLACE));
    set(1, PLACE);
    EXPECT_EQ(execute(STRT), sim::ArmStop::DATA_ABORT);
    EXPECT_EQ(bench.core.fault().status, PERMISSION | OF_PAGE);
    EXPECT_TRUE(bench.core.fault().write);
    EXPECT_TRUE(goes(STR, PLACE));
    give(PRIVILEGED_ALONE);
    expect_refused(LDRT, PLACE, PERMISSION | OF_PAGE);
    EXPECT_TRUE(goes(LDR, PLACE));
}

TEST_P(UserRights, LoadAndStoreEachSize) {
    give(FULL);
    const std::pair<Both, std::uint32_t> loads[] = {
        {{0xE4F12001, 0xF8112E00}, 0xF4},        // LDRBT
        {{0xE0F120B2, 0xF8312E00}, 0xF3F4},      // LDRHT
        {{0xE0F120D0, 0xF9112E00}, 0xFFFFFFF4},  // LDRSBT
        {{0xE0F120F0, 0xF9312E00}, 0xFFFFF3F4},  // LDRSHT
    };
    for (const auto& [instruction, expected] : loads) {
        set(1, PLACE);
        done(instruction);
        EXPECT_EQ(reg(2), expected) << std::hex << instruction.arm;
    }
    set(1, PLACE);
    set(2, 0x11223344);
    done({0xE0E120B4, 0xF8212E00});  // STRHT
    EXPECT_EQ(bench.word(HERE), 0x81823344u);
    EXPECT_EQ(reg(1), thumb() ? PLACE : PLACE + 4) << "after the access";
    set(1, PLACE);
    set(2, 0x55);
    done({0xE4E12000, 0xF8012E00});  // STRBT
    EXPECT_EQ(bench.word(HERE), 0x81823355u);
}

TEST_P(UserRights, DoNotMatterToSwpWhichSctlrSwSwitchesOn) {
    if (thumb()) return;
    give(FULL);
    constexpr Both SWP{0xE1012093, 0}, SWPB{0xE1412093, 0};  // r2, r3, [r1]
    set(1, PLACE);
    refused(SWP);
    write(sim::cp15::SCTLR, SCTLR_M | 1u << 10);
    set(1, PLACE);
    set(3, 0x01020304);
    done(SWP);
    EXPECT_EQ(reg(2), 0x8182F3F4u);
    EXPECT_EQ(bench.word(HERE), 0x01020304u);
    set(3, 0x99);
    done(SWPB);
    EXPECT_EQ(reg(2), 4u);
    EXPECT_EQ(bench.word(HERE), 0x01020399u);
}

INSTANTIATE_TEST_SUITE_P(In, UserRights, ::testing::Combine(::testing::Bool(), ::testing::Bool()),
                         name_of_way);

}  // namespace user_rights
