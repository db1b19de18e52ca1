// Big-endian data, by CPSR.E (ARM ARM, A3.3, A8.8.160): in RAM and on the bus, for instructions
// that are translated and for others.
#include <gmock/gmock.h>

#include "tb/sim/arm_core/system_bench.h"

namespace big_endian {

using namespace tb::core;

constexpr std::uint32_t PLACE = 0x4000, LAND = 0x9000;

class BigEndian : public SystemTest {
protected:
    void SetUp() override {
        bench.put(PLACE, {0x11223384, 0x55667788});
        done({0xF1010200, 0xB658});  // SETEND BE
        EXPECT_EQ(cpsr() & E, E);
    }
    void at(std::uint32_t place, Both instruction) {
        set(1, place);
        done(instruction);
    }
};

TEST_P(BigEndian, LoadsTheHighestByteFirst) {
    at(PLACE, {0xE5912000, 0x680A});  // LDR r2, [r1]
    EXPECT_EQ(reg(2), 0x84332211u);
    at(PLACE, {0xE1D120B0, 0x880A});  // LDRH r2, [r1]
    EXPECT_EQ(reg(2), 0x8433u);
    at(PLACE, {0xE1D120F0, 0xF9B12000});  // LDRSH r2, [r1]
    EXPECT_EQ(reg(2), 0xFFFF8433u);
    at(PLACE, {0xE5D12000, 0x780A});  // LDRB r2, [r1]
    EXPECT_EQ(reg(2), 0x84u);
    at(PLACE, {0xE1C120D0, 0xE9D12300});  // LDRD r2, r3, [r1]
    EXPECT_EQ(reg(2), 0x84332211u);
    EXPECT_EQ(reg(3), 0x88776655u);
    at(PLACE, {0xED910A00, 0xED910A00});  // VLDR s0, [r1]
    EXPECT_EQ(bench.core.vfp(0) & 0xFFFFFFFF, 0x84332211u);
    at(PLACE, {0xED910B00, 0xED910B00});  // VLDR d0, [r1]
    EXPECT_EQ(bench.core.vfp(0), 0x8433221188776655u);
}

TEST_P(BigEndian, StoresTheHighestByteFirst) {
    set(2, 0xAABBCCDD);
    at(PLACE, {0xE5812000, 0x600A});  // STR r2, [r1]
    EXPECT_EQ(bench.word(PLACE), 0xDDCCBBAAu);
    at(PLACE, {0xE1C120B0, 0x800A});  // STRH r2, [r1]
    EXPECT_EQ(bench.word(PLACE), 0xDDCCDDCCu);
    set(3, 0x12345678);
    at(PLACE, {0xE881000C, 0xE881000C});  // STM r1, {r2, r3}
    EXPECT_EQ(bench.word(PLACE + 4), 0x78563412u);
}

TEST_P(BigEndian, LoadsMultiplesWithAndWithoutTheirBase) {
    at(PLACE, {0xE891000C, 0xE891000C});  // LDM r1, {r2, r3}
    EXPECT_EQ(reg(2), 0x84332211u);
    EXPECT_EQ(reg(3), 0x88776655u);
    at(PLACE, {0xE8910006, 0xC906});  // LDM r1, {r1, r2}
    EXPECT_EQ(reg(1), 0x84332211u);
    EXPECT_EQ(reg(2), 0x88776655u);
}

// The same instruction several times: at its first execution it is translated as if it accessed
// RAM.
TEST_P(BigEndian, TurnsWhatIsOnTheBusEachTime) {
    const auto again = [&](const std::function<void()>& check) {
        for (unsigned i = 0; i < 4; ++i) {
            check();
            set(15, AT);
            ASSERT_EQ(run(), sim::ArmStop::WFI);
        }
        check();
    };
    at(BUS, {0xE5912000, 0x680A});  // LDR r2, [r1]
    again([&] { EXPECT_EQ(reg(2), __builtin_bswap32(bench.accesses.back().value)); });
    at(BUS, {0xE1D120F0, 0xF9B12000});  // LDRSH r2, [r1]
    again([&] {
        const std::uint16_t turned =
            __builtin_bswap16(static_cast<std::uint16_t>(bench.accesses.back().value));
        EXPECT_EQ(reg(2), static_cast<std::uint32_t>(static_cast<std::int16_t>(turned)));
    });
    set(2, 0xAABBCCDD);
    at(BUS, {0xE5812000, 0x600A});  // STR r2, [r1]
    again([&] { EXPECT_EQ(bench.accesses.back().value, 0xDDCCBBAAu); });
    at(BUS, {0xE1C120B0, 0x800A});  // STRH r2, [r1]
    again([&] { EXPECT_EQ(bench.accesses.back().value, 0xDDCCu); });
    at(BUS, {0xE5C12000, 0x700A});  // STRB r2, [r1]
    again([&] { EXPECT_EQ(bench.accesses.back().value, 0xDDu); });
}

TEST_P(BigEndian, SavesAndTakesStatesSo) {
    become(SVC | E);
    set(13, PLACE);
    set(14, 0x12345678);
    bench.core.set_spsr(0xF00001D3);
    done({0xF8CD0513, 0xE98DC013});  // SRSIA sp, #SVC
    EXPECT_EQ(bench.word(PLACE), 0x78563412u);
    EXPECT_EQ(bench.word(PLACE + 4), 0xD30100F0u);

    put_landing(LAND, false);
    bench.put(PLACE, {__builtin_bswap32(LAND), __builtin_bswap32(SYS | N)});
    at(PLACE, {0xF8910A00, 0xE991C000});  // RFEIA r1
    EXPECT_EQ(bench.core.cpsr(), SYS | N);
    EXPECT_EQ(bench.core.pc(), LAND + 4);
}

TEST_P(BigEndian, SavesAndTakesTheUsersRegistersSo) {
    if (thumb()) return;  // it has no such instruction
    become(SVC | E);
    at(PLACE, {0xE8D16000, 0});      // LDM r1, {sp, lr}^
    at(PLACE + 8, {0xE8C16000, 0});  // STM r1, {sp, lr}^
    EXPECT_EQ(bench.word(PLACE + 8), 0x11223384u);
    become(SYS);
    EXPECT_EQ(reg(13), 0x84332211u);
    EXPECT_EQ(reg(14), 0x88776655u);
}

INSTANTIATE_TEST_SUITE_P(In, BigEndian, ::testing::Combine(::testing::Bool(), ::testing::Bool()),
                         name_of_way);

}  // namespace big_endian
