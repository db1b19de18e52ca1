// fabric_ports_test.cpp - fpga.v's pins and interrupts of the ports of which there are two
#include <gmock/gmock.h>

#include "tb/rtl/fabric_bench.h"

namespace {

using namespace regmap;
using namespace tb;
using ::testing::ElementsAre;
using ::testing::SizeIs;

constexpr unsigned QUARTER = 500;  // clocks, of a PS/2 device's bit of 80 us

// ---- PS/2 ----

class FabricPs2 : public FabricPorts {
protected:
    void pull(unsigned clk_low, unsigned dat_low, unsigned quarters) {
        pins.device_clk_low = clk_low;
        pins.device_dat_low = dat_low;
        pins.wires(fabric.in);
        fabric.run_clocks(quarters * QUARTER);
    }
    void device_sends(unsigned port, std::uint8_t byte) {
        unsigned ones = 0;
        for (int i = 0; i < 8; ++i) ones += byte >> i & 1;
        const unsigned frame = static_cast<unsigned>(byte) << 1 | (ones % 2 ? 0u : 0x200u) | 0x400u;
        for (int bit = 0; bit < 11; ++bit) {
            const unsigned dat_low = (frame >> bit & 1) ? 0u : 1u << port;
            pull(0, dat_low, 1);
            pull(1u << port, dat_low, 2);
            pull(0, dat_low, 1);
        }
        pull(0, 0, 4);
    }
    // Ten bits and the acknowledge.
    unsigned device_takes(unsigned port) {
        unsigned bits = 0;
        for (int bit = 0; bit < 10; ++bit) {
            pull(1u << port, 0, 2);
            bits |= (fabric.in.ps2_dat >> port & 1u) << bit;
            pull(0, 0, 2);
        }
        pull(0, 1u << port, 1);
        pull(1u << port, 1u << port, 2);
        pull(0, 0, 4);
        return bits;
    }
    static constexpr std::uint32_t data[] = {PS2_0_DATA, PS2_1_DATA};
    static constexpr std::uint32_t control[] = {PS2_0_CONTROL, PS2_1_CONTROL};
    static constexpr unsigned id[] = {79, 95};
};

TEST_F(FabricPs2, GivesEachPortsBytesAtItsOwnRegister) {
    for (const unsigned port : {0u, 1u}) {
        const auto byte = static_cast<std::uint8_t>(0x1c + port);
        device_sends(port, byte);
        EXPECT_EQ(read(data[1 - port]) & PS2_0_DATA_RVALID_MASK, 0u);
        EXPECT_EQ(read(data[port]), 1u << 16 | PS2_0_DATA_RVALID_MASK | byte);
        EXPECT_EQ(read(data[port]), byte);
    }
}

TEST_F(FabricPs2, InterruptsWithEachPortsNumber) {
    for (const unsigned port : {0u, 1u}) {
        device_sends(port, 0x55);
        write(control[1 - port], PS2_0_CONTROL_RE_MASK);
        EXPECT_EQ(fabric.interrupts(), 0u);
        write(control[1 - port], 0);
        write(control[port], PS2_0_CONTROL_RE_MASK);
        EXPECT_EQ(fabric.interrupts(), irq_of(id[port]));
        write(control[port], 0);
        read(data[port]);
    }
}

TEST_F(FabricPs2, HoldsClockLow120MicrosecondsThenPullsData) {
    for (const unsigned port : {0u, 1u}) {
        pins.pulls.clear();
        begin_write(data[port], 0xf4);
        fabric.run_clocks(5'000);
        ASSERT_THAT(pins.pulls, SizeIs(2));
        EXPECT_EQ(pins.pulls[0].clk_low, 1u << port);
        EXPECT_EQ(pins.pulls[0].dat_low, 0u);
        EXPECT_EQ(pins.pulls[1].clk_low, 0u);
        EXPECT_EQ(pins.pulls[1].dat_low, 1u << port);
        const std::uint64_t held = pins.pulls[1].clock - pins.pulls[0].clock;
        EXPECT_GE(held, 3'000u);
        EXPECT_LE(held, 3'100u);
        EXPECT_FALSE(written());
        EXPECT_EQ(device_takes(port), 0xf4u | 0 << 8 | 1 << 9);
        EXPECT_TRUE(written());
        EXPECT_EQ(read(control[0]) | read(control[1]), 0u);
    }
}

// ---- JTAG UARTs ----

TEST_F(FabricPorts, TakeWhatIsTypedAtTheirOwnTerminal) {
    constexpr std::uint32_t data[] = {JTAG_UART0_DATA, JTAG_UART1_DATA};
    for (const unsigned number : {0u, 1u}) {
        fabric.jtag.typed = static_cast<std::uint8_t>(1u << number);
        fabric.jtag.bytes = 0xA1 | 0xB2 << 8;
        fabric.run_clocks(10);
        EXPECT_EQ(read(data[1 - number]) & JTAG_UART0_DATA_RVALID_MASK, 0u);
        EXPECT_EQ(read(data[number]) & 0x80FF, 0x8000u | (number ? 0xB2 : 0xA1));
        EXPECT_EQ(read(data[number]) & JTAG_UART0_DATA_RVALID_MASK, 0u);
    }
}

TEST_F(FabricPorts, SendToTheirOwnTerminal) {
    std::vector<std::pair<unsigned, char>> sent;
    fabric.on_jtag_byte(
        [&sent](unsigned number, char byte, sim::JtagInputs&) { sent.emplace_back(number, byte); });
    fabric.jtag.take = 3;
    write(JTAG_UART1_DATA, 'x');
    write(JTAG_UART0_DATA, 'y');
    EXPECT_THAT(sent, ElementsAre(std::pair{1u, 'x'}, std::pair{0u, 'y'}));
}

TEST_F(FabricPorts, KnowTheirOwnTerminalByItsLooks) {
    constexpr std::uint32_t control[] = {JTAG_UART0_CONTROL, JTAG_UART1_CONTROL};
    for (const unsigned number : {1u, 0u}) {
        EXPECT_EQ(read(control[number]) & JTAG_UART0_CONTROL_AC_MASK, 0u);
        fabric.jtag.idle = static_cast<std::uint8_t>(1u << number);
        fabric.run_clocks(10);
        EXPECT_EQ(read(control[number]) & JTAG_UART0_CONTROL_AC_MASK, JTAG_UART0_CONTROL_AC_MASK);
    }
}

TEST_F(FabricPorts, InterruptForEachTerminalWithItsNumber) {
    for (const std::uint32_t control : {JTAG_UART0_CONTROL, JTAG_UART1_CONTROL})
        write(control, JTAG_UART0_CONTROL_RE_MASK);
    for (const unsigned number : {1u, 0u}) {
        fabric.jtag.typed = static_cast<std::uint8_t>(1u << number);
        fabric.run_clocks(10);
        fabric.jtag.idle = static_cast<std::uint8_t>(1u << number);
        fabric.run_clocks(10);
        EXPECT_EQ(fabric.interrupts(), irq_of(number ? 112 : 80));
        read(number ? JTAG_UART1_DATA : JTAG_UART0_DATA);
    }
}

// ---- The other interrupts ----

TEST_F(FabricPorts, InterruptWithEachBlocksNumber) {
    struct Interrupt {
        const char* block;
        unsigned id;
        std::uint32_t enable, value;  // register, what enables it
        std::function<void()> happen;
    };
    const Interrupt interrupts[] = {
        {"timer 0", TIMER0_IRQ_ID, TIMER0_CONTROL, TIMER0_CONTROL_ITO_MASK,
         [this] { write(TIMER0_PERIOD_HIGH, 0), write(TIMER0_PERIOD_LOW, 0); }},
        {"timer 1", TIMER1_IRQ_ID, TIMER1_CONTROL, TIMER0_CONTROL_ITO_MASK,
         [this] { write(TIMER1_PERIOD_HIGH, 0), write(TIMER1_PERIOD_LOW, 0); }},
        {"push buttons", KEY_IRQ_ID, KEY_MASK, 1,
         [this] {
             fabric.in.key_n = 0xe, fabric.run_clocks(10), fabric.in.key_n = 0xf,
             fabric.run_clocks(10);
         }},
        {"keypad", KEYPAD_IRQ_ID, KEYPAD_MASK, KEYPAD_STATUS_EVENT_MASK,
         [this] {
             write(KEYPAD_DEBOUNCE, 1);
             pins.on_headers = [this](sim::ChipInputs& in) {  // key 0: its row and its column
                 const std::uint64_t column = std::uint64_t{1} << 9, row = std::uint64_t{1} << 5;
                 const bool low = pins.driven.enable[0] & ~pins.driven.levels[0] & column;
                 in.gpio[0] = sim::ALL_HEADER_PINS & ~(low ? row | column : 0);
             };
             write(KEYPAD_CONTROL, 1);
             fabric.run_clocks(4 * 4 * 1250);
         }},
        {"IrDA", IRDA_IRQ_ID, IRDA_CONTROL, IRDA_CONTROL_WE_MASK, [] {}},
        {"audio", AUDIO_IRQ_ID, AUDIO_CONTROL, AUDIO_CONTROL_WE_MASK, [] {}},
    };
    for (const Interrupt& each : interrupts) {
        each.happen();
        EXPECT_EQ(fabric.interrupts(), 0u) << each.block;
        write(each.enable, each.value);
        EXPECT_EQ(fabric.interrupts(), irq_of(each.id)) << each.block;
        write(each.enable, 0);
    }
}

// ---- Headers, picture ----

TEST_F(FabricPorts, InterruptForAFallingPinOfTheirHeader) {
    constexpr std::uint32_t mask[] = {JP1_MASK, JP2_MASK}, edge[] = {JP1_EDGE, JP2_EDGE};
    constexpr unsigned id[] = {JP1_IRQ_ID, JP2_IRQ_ID};
    for (const unsigned header : {0u, 1u}) {
        write(mask[header], 0x80000001);
        for (const unsigned pin : {1u, 35u}) {  // bits 0 and 31
            fabric.in.gpio[1 - header] &= ~(std::uint64_t{1} << pin);
            fabric.run_clocks(10);
            EXPECT_EQ(fabric.interrupts(), 0u) << "the other header's";
            fabric.in.gpio[header] &= ~(std::uint64_t{1} << pin);
            fabric.run_clocks(10);
            EXPECT_EQ(fabric.interrupts(), irq_of(id[header])) << pin;
            EXPECT_EQ(read(edge[header]), pin == 1 ? 1u : 0x80000000u);
            for (const unsigned each : {0u, 1u}) {
                fabric.in.gpio[each] |= std::uint64_t{1} << pin;
                write(edge[each], 0xffffffff);
            }
            EXPECT_EQ(fabric.interrupts(), 0u);
        }
        write(mask[header], 0);
    }
}

TEST_F(FabricPorts, DriveTheFirstAndTheLastPinOfTheirHeader) {
    constexpr std::uint32_t direction[] = {JP1_DIR, JP2_DIR}, data[] = {JP1_DATA, JP2_DATA};
    constexpr std::uint64_t FIRST = std::uint64_t{1} << 1, LAST = std::uint64_t{1} << 35;
    for (const unsigned header : {0u, 1u}) {
        write(direction[header], 0x80000001);  // bits 0 and 31
        for (const auto& [bits, levels] :
             {std::pair{0x00000001u, FIRST}, std::pair{0x80000000u, LAST}}) {
            write(data[header], bits);
            fabric.run_clocks(10);
            EXPECT_EQ(pins.driven.enable[header], FIRST | LAST);
            EXPECT_EQ(pins.driven.levels[header] & (FIRST | LAST), levels);
        }
    }
}

TEST_F(FabricPorts, SendNoSyncOnGreen) {
    fabric.run_clocks(800 * 525);
    fabric.flush();
    EXPECT_GE(pins.samples, 800u * 525);
    EXPECT_EQ(pins.with_sync, 0u);
}

TEST_F(FabricPorts, ShowAPictureThatBeginsMidWord) {
    constexpr unsigned FRAME = 800 * 525;
    put(ONCHIP_BASE, {0x00, 0xF8, 0xE0, 0x07, 0x1F, 0x00, 0x00, 0x00});  // red, green, blue, black
    write(PIXEL_BACK_BUFFER, ONCHIP_BASE + 2);
    write(PIXEL_BUFFER, 1);
    fabric.run_clocks(2 * FRAME);
    fabric.flush();
    pins.lit.clear();
    fabric.run_clocks(FRAME);
    fabric.flush();
    constexpr std::uint32_t G = 0x00FF00, B = 0x0000FF;
    EXPECT_THAT(pins.lit, ElementsAre(G, G, B, B, G, G, B, B)) << "each pixel twice in two lines";
}

}  // namespace
