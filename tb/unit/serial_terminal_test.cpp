// serial_terminal_test.cpp - a serial terminal, bit by bit at its pins.
#include "sim/board/serial_terminal.h"

#include <gmock/gmock.h>

#include <utility>
#include <vector>

namespace {

constexpr std::uint64_t BIT_PS = 1'000'000;  // 1 Mbaud
constexpr sim::HeaderPin RX = 3, TX = 38;

class SerialTerminalTest : public ::testing::Test {
protected:
    sim::Agenda agenda;
    std::vector<std::pair<std::uint64_t, bool>> driven;
    bool tx = true;
    const sim::PartSocket socket{agenda,
                                 [this](const sim::HeaderMasks& pins, sim::PinLevel pin) {
                                     EXPECT_EQ(pins, sim::mask_of({TX}));
                                     const bool level = pin == sim::PinLevel::HIGH;
                                     if (std::exchange(tx, level) != level)
                                         driven.emplace_back(agenda.now_ps(), level);
                                 },
                                 [] {}};
    sim::SerialTerminal terminal{RX, TX, 1'000'000, socket};

    void look(bool rx) { terminal.look({rx ? 1u << RX : 0u, 0}, agenda.now_ps()); }

    // A byte of another's transmitter, whose bits take `bit_ps`.
    void receive(unsigned byte, std::uint64_t bit_ps = BIT_PS, bool stop = true) {
        const unsigned bits = byte << 1 | (stop ? 0x200u : 0u);
        for (unsigned n = 0; n < 10; ++n) {
            look(bits >> n & 1);
            agenda.run_to(agenda.now_ps() + bit_ps);
        }
        look(true);
    }
};

TEST_F(SerialTerminalTest, ReadsBitsAtARate4PercentOff) {
    for (const std::uint64_t bit_ps : {BIT_PS, BIT_PS * 96 / 100, BIT_PS * 104 / 100})
        for (unsigned byte = 0; byte < 256; ++byte) receive(byte, bit_ps);
    ASSERT_EQ(terminal.received().size(), 768u);
    for (unsigned n = 0; n < 768; ++n)
        ASSERT_EQ(static_cast<std::uint8_t>(terminal.received()[n]), n % 256) << n;
    EXPECT_EQ(terminal.lost(), 0u);
}

TEST_F(SerialTerminalTest, LosesAByteWithoutAStopBit) {
    receive('a');
    receive('b', BIT_PS, false);
    agenda.run_to(agenda.now_ps() + BIT_PS);
    receive('c');
    EXPECT_EQ(terminal.received(), "ac");
    EXPECT_EQ(terminal.lost(), 1u);
}

TEST_F(SerialTerminalTest, IgnoresAPulseShorterThanHalfABit) {
    look(false);
    agenda.run_to(agenda.now_ps() + BIT_PS / 3);
    look(true);
    agenda.run_to(agenda.now_ps() + 20 * BIT_PS);
    EXPECT_EQ(terminal.received(), "");
    receive('x');
    EXPECT_EQ(terminal.received(), "x");
}

TEST_F(SerialTerminalTest, SendsBytesWithoutAPause) {
    agenda.run_to(5 * BIT_PS);
    terminal.type("U\x0f");  // from bit 0 on 10101010, 11110000
    agenda.run_to(99 * BIT_PS);
    std::vector<std::pair<std::uint64_t, bool>> expected;
    for (unsigned n = 0; n < 10; ++n) expected.emplace_back((5 + n) * BIT_PS, n % 2);
    expected.emplace_back(15 * BIT_PS, false);
    expected.emplace_back(16 * BIT_PS, true);
    expected.emplace_back(20 * BIT_PS, false);
    expected.emplace_back(24 * BIT_PS, true);
    EXPECT_EQ(driven, expected);
    terminal.type("!");
    agenda.run_to(99 * BIT_PS + 1);
    EXPECT_EQ(driven.back(), std::pair(99 * BIT_PS, false));
}

}  // namespace
