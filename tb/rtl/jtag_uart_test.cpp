// jtag_uart_test.cpp - the JTAG UART from both sides: registers, and the host's handshake.
#include <gtest/gtest.h>

#include <string>

#include "Vjtag_uart.h"
#include "regmap.h"
#include "tb/support/register_bus.h"

namespace {

#define FIELD(name) name = regmap::JTAG_UART0_CONTROL_##name##_MASK
constexpr std::uint32_t DATA = regmap::JTAG_UART0_DATA, CONTROL = regmap::JTAG_UART0_CONTROL,
                        FIELD(RE), FIELD(WE), FIELD(RI), FIELD(WI), FIELD(AC), FIELD(WAITS),
                        FIELD(ROOM), FIELD(LOST), FIELD(RVALID);
#undef FIELD

class JtagUart : public tb::RegisterBus<Vjtag_uart> {
protected:
    void SetUp() override {
        dut.take_i = dut.typed_i = dut.idle_i = 0;
        reset();
        clock();
    }
    void after_clock() override {
        if (dut.sent_o) sent += static_cast<char>(dut.sent_data_o);
    }
    // The host takes one byte, as alt_jtag_atlantic does: it requests until sent_o.
    void take() {
        const auto before = sent.size();
        dut.take_i = 1;
        for (int i = 0; i < 4 && sent.size() == before; ++i) clock();
        dut.take_i = 0;
        clock(2);
    }
    void type(const std::string& text) {
        for (const char c : text) {
            dut.typed_data_i = static_cast<std::uint8_t>(c);
            dut.typed_i = 1;
            clock();
        }
        dut.typed_i = 0;
    }
    void idle() {
        dut.idle_i = 1;
        clock();
        dut.idle_i = 0;
    }
    std::uint32_t space() { return read(CONTROL) >> 16; }

    std::string sent;
};

TEST_F(JtagUart, SendsBytesInOrderEachOnce) {
    for (const char c : std::string("abc")) write(DATA, static_cast<std::uint8_t>(c));
    clock(20);
    EXPECT_EQ(sent, "");
    take();
    EXPECT_EQ(sent, "a");
    take();
    take();
    take();
    EXPECT_EQ(sent, "abc");
}

TEST_F(JtagUart, HasRoomFor64BytesAndDropsWhatIsMore) {
    EXPECT_EQ(space(), 64u);
    for (unsigned i = 0; i < 70; ++i) {
        EXPECT_EQ(space(), i < 64 ? 64 - i : 0);
        write(DATA, i);
    }
    for (int i = 0; i < 70; ++i) take();
    EXPECT_EQ(sent.size(), 64u);
    EXPECT_EQ(sent.back(), 63);
    EXPECT_EQ(space(), 64u);
}

TEST_F(JtagUart, GivesTypedBytesOnceWithTheNumberLeft) {
    type("xy\xfa");
    constexpr std::uint32_t STATE = ROOM | AC;
    EXPECT_EQ(read(DATA), 2u << 16 | RVALID | WAITS | STATE | 'x');
    EXPECT_EQ(read(DATA), 1u << 16 | RVALID | WAITS | STATE | 'y');
    EXPECT_EQ(read(DATA), 0u << 16 | RVALID | STATE | 0xfa);
    EXPECT_EQ(read(DATA), STATE | 0xfa) << "empty: the last byte, not valid";
}

TEST_F(JtagUart, KeepsTheByteWhenControlIsRead) {
    type("x");
    read(CONTROL);
    EXPECT_EQ(read(DATA), RVALID | ROOM | AC | 'x');
}

TEST_F(JtagUart, ControlShowsWhetherTheLastReadOfDataWasValid) {
    type("x");
    EXPECT_EQ(read(CONTROL) & (RVALID | WAITS), WAITS);
    read(DATA);
    EXPECT_EQ(read(CONTROL) & (RVALID | WAITS), RVALID);
    read(DATA);
    EXPECT_EQ(read(CONTROL) & (RVALID | WAITS), 0u);
}

TEST_F(JtagUart, ReportsAFullFifoAndALostByte) {
    for (int i = 0; i < 64; ++i) write(DATA, 'x');
    EXPECT_EQ(read(CONTROL) & (ROOM | LOST), 0u);
    write(DATA, 'x');
    EXPECT_EQ(read(CONTROL) & (ROOM | LOST), LOST);
    EXPECT_EQ(read(DATA), LOST);
    take();
    EXPECT_EQ(read(CONTROL) & (ROOM | LOST), ROOM | LOST);
    write(DATA, 'x');
    EXPECT_EQ(read(CONTROL) & (ROOM | LOST), 0u);
}

TEST_F(JtagUart, StopsTheHostAt64Bytes) {
    type(std::string(63, 'x'));
    clock();
    EXPECT_EQ(dut.room_o, 1);
    type("x");
    clock();
    EXPECT_EQ(dut.room_o, 0);
    read(DATA);
    clock(2);
    EXPECT_EQ(dut.room_o, 1);
}

TEST_F(JtagUart, ShowsThatTheHostIsThereUntilThatIsCleared) {
    EXPECT_EQ(read(CONTROL) & AC, 0u);
    idle();
    EXPECT_EQ(read(CONTROL) & AC, AC);
    write(CONTROL, 0);
    EXPECT_EQ(read(CONTROL) & AC, AC);
    write(CONTROL, AC);
    EXPECT_EQ(read(CONTROL) & AC, 0u);
    type("x");
    EXPECT_EQ(read(CONTROL) & AC, AC);
}

TEST_F(JtagUart, InterruptsWhenEightOrFewerBytesWaitForTheHost) {
    for (int i = 0; i < 9; ++i) write(DATA, 'x');
    EXPECT_EQ(dut.irq_o, 0);
    write(CONTROL, WE);
    EXPECT_EQ(read(CONTROL) & (RE | WE | RI | WI), WE);
    EXPECT_EQ(dut.irq_o, 0);
    take();
    EXPECT_EQ(read(CONTROL) & (RI | WI), WI);
    EXPECT_EQ(dut.irq_o, 1);
    write(CONTROL, 0);
    EXPECT_EQ(dut.irq_o, 0);
}

TEST_F(JtagUart, InterruptsAfterTheHostPausesUntilDataIsRead) {
    write(CONTROL, RE);
    idle();
    EXPECT_EQ(dut.irq_o, 0);
    type("xy");
    EXPECT_EQ(dut.irq_o, 0);
    idle();
    clock();
    EXPECT_EQ(dut.irq_o, 1);
    EXPECT_EQ(read(CONTROL) & (RI | WI), RI);
    read(DATA);
    EXPECT_EQ(dut.irq_o, 0);
}

TEST_F(JtagUart, InterruptsWithEightFreePlacesOrFewer) {
    write(CONTROL, RE);
    type(std::string(55, 'x'));
    EXPECT_EQ(dut.irq_o, 0);
    type("x");
    EXPECT_EQ(dut.irq_o, 1);
}

TEST_F(JtagUart, IgnoresAWriteWithoutItsByteLane) {
    write(DATA, 0x4141, 0xe);
    EXPECT_EQ(space(), 64u);
    write(CONTROL, RE | WE, 0xe);
    EXPECT_EQ(read(CONTROL) & (RE | WE), 0u);
    idle();
    write(CONTROL, AC, 0xd);
    EXPECT_EQ(read(CONTROL) & AC, AC);
    write(CONTROL, AC, 0x2);
    EXPECT_EQ(read(CONTROL) & AC, 0u);
}

}  // namespace
