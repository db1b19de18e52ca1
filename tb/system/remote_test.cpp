// remote_test.cpp - a button of the remote control, read by a program byte by byte.
#include "regmap.h"
#include "sim/board/nec_frame.h"
#include "tb/support/whole_board.h"

namespace {

class Remote : public tb::WholeBoard {
protected:
    std::vector<std::uint32_t> words;  // received

    // The receiver's bytes come while there is light, so a byte after a pause begins a light.
    // From one beginning to the next it is 1.125 ms for a 0, 2.25 ms for a 1, 13.5 ms for the lead.
    void decode(hal::Mmio& io, hal::Cpu& cpu, std::size_t count) {
        std::uint32_t seen = 0, began = 0, word = 0;
        unsigned bits = 32;
        while (words.size() < count) {
            if (!(io.read(regmap::IRDA_DATA) & regmap::IRDA_DATA_RVALID_MASK)) {
                cpu.idle();
                continue;
            }
            const std::uint32_t now = cpu.micros();
            if (now - seen > 300) {
                const std::uint32_t since = now - began;
                began = now;
                if (since > 10'000) {
                    bits = 0;
                } else if (bits < 32) {
                    word = word >> 1 | (since > 1'700 ? 0x80000000u : 0);
                    if (++bits == 32) words.push_back(word);
                }
            }
            seen = now;
        }
    }
};

// As the manual of a system with the same remote control lists them.
TEST_F(Remote, SendsTheCodesOfItsButtons) {
    power_on([this](hal::Mmio& io, hal::Cpu& cpu) { decode(io, cpu, 3); });
    for (const char* name : {"5", "power", "volume-down"})
        board->remote_control.press(sim::remote_button(name).value());
    run_ms(350);
    EXPECT_EQ(words, (std::vector<std::uint32_t>{0xfa056b86, 0xed126b86, 0xe01f6b86}));
}

TEST_F(Remote, InterruptsAsIrda) {
    std::uint32_t before = 1, after = 0;
    power_on([&](hal::Mmio& io, hal::Cpu& cpu) {
        io.write(regmap::IRDA_CONTROL, regmap::IRDA_CONTROL_RE_MASK);
        idle_ms(cpu, 5);
        before = computer->fabric.interrupts();
        idle_ms(cpu, 10);  // more than 8.4 ms of light: 96 bytes
        after = computer->fabric.interrupts();
    });
    run_ms(5);
    board->remote_control.press(0);
    run_ms(20);
    EXPECT_EQ(before, 0u);
    EXPECT_EQ(after, 1u << (81 - 72));
}

}  // namespace
