// The HPS's timers, UART0, GPIO1 and managers, at their registers and interrupts.
#include "tb/sim/hps_bench.h"

namespace {

// ---- Timers -------------------------------------------------------------------------------------

constexpr std::uint32_t ENABLE = 1, USER = 2, MASKED = 4;

class HpsTimer : public tb::HpsBench {
protected:
    static constexpr std::uint32_t T0 = 0xFFC08000,
                                   BASES[] = {T0, 0xFFC09000, 0xFFD00000, 0xFFD01000};
    void start(std::uint32_t timer, std::uint32_t load, std::uint32_t control) {
        write(timer, load);
        write(timer + 8, control | ENABLE);
    }
};

TEST_F(HpsTimer, CountsDownAt100MhzAndTheOthersAt25) {
    for (const std::uint32_t timer : BASES) start(timer, 1'000'000, USER | MASKED);
    wait_ms(1);
    for (int i = 0; i < 4; ++i) EXPECT_NEAR(read(BASES[i] + 4), i < 2 ? 900'000 : 975'000, 1);
}

TEST_F(HpsTimer, InterruptsWithItsOwnId) {
    for (unsigned i = 0; i < 4; ++i) {
        take(199 + i);
        start(BASES[i], 1000, USER);
        wait_ms(0.041);
        EXPECT_EQ(acknowledge(), 199 + i);
        write(BASES[i] + 8, 0);
        end(199 + i);
    }
}

TEST_F(HpsTimer, IsQuietedByReadingItsEoi) {
    take(199);
    start(T0, 99'999, USER);
    wait_ms(1.001);
    EXPECT_EQ(read(T0 + 0x10), 1u);
    read(T0 + 0x0C);
    EXPECT_EQ(read(T0 + 0x10), 0u);
    EXPECT_FALSE(board.irq);
    wait_ms(1);
    EXPECT_TRUE(board.irq) << "and rings again";
}

TEST_F(HpsTimer, ShowsARawStatusWhileMasked) {
    take(199);
    start(T0, 100, USER | MASKED);
    wait_ms(1);
    EXPECT_EQ(read(T0 + 0x10), 0u);
    EXPECT_EQ(read(T0 + 0xA8), 1u);
    EXPECT_FALSE(board.irq);
}

TEST_F(HpsTimer, StartsFromItsLoadEachTimeItIsEnabled) {
    start(T0, 1000, USER | MASKED);
    wait_ns(5000);
    write(T0 + 8, 0);
    start(T0, 1000, USER | MASKED);
    EXPECT_NEAR(read(T0 + 4), 1000, 1);
}

TEST_F(HpsTimer, RunsOnFromTheTopWithoutTheUsersMode) {
    start(T0, 100, MASKED);
    wait_ns(2010);
    EXPECT_NEAR(read(T0 + 4), 0xFFFFFFFF - 100.0, 3);
}

// ---- UART0 --------------------------------------------------------------------------------------

class Uart0 : public tb::HpsBench {
protected:
    static constexpr std::uint32_t UART = 0xFFC02000;
};

TEST_F(Uart0, PrintsAfterABootLoadersSetUp) {
    write(UART + 0x0C, 0x83);  // DLAB, 8 bits
    write(UART + 0x00, 54);    // 115,200 baud
    write(UART + 0x04, 0);
    write(UART + 0x0C, 0x03);
    write(UART + 0x08, 0x07);
    write(UART + 0x10, 0x03);
    EXPECT_EQ(read(UART + 0x14) & 0x61, 0x60u) << "empty, nothing received";
    EXPECT_EQ(read(UART + 0x7C) & 0x02, 0x02u) << "FIFO not full";
    for (const char c : std::string{"ok\n"}) write(UART, static_cast<unsigned char>(c));
    wait_ns(3 * 86'400 + 20);
    EXPECT_EQ(board.printed, "ok\n");
}

TEST_F(Uart0, KeepsItsDivisorUnderDlab) {
    write(UART + 0x0C, 0x80);
    write(UART + 0x00, 0x36);
    write(UART + 0x04, 0x01);
    EXPECT_EQ(read(UART + 0x00), 0x36u);
    EXPECT_EQ(read(UART + 0x04), 0x01u);
    EXPECT_EQ(board.printed, "");
}

TEST_F(Uart0, InterruptsForAnEmptyTransmitterUntilTheIdIsRead) {
    take(194);
    write(UART + 0x04, 2);
    EXPECT_TRUE(board.irq);
    EXPECT_EQ(read(UART + 0x08) & 0xF, 2u);
    EXPECT_FALSE(board.irq);
    write(UART, 'x');
    EXPECT_TRUE(board.irq);
}

TEST_F(Uart0, TakesTheTimeOfItsBaudRate) {
    constexpr double CHARACTER_NS = 10 * 16 * 54 * 10;  // 115,741 baud
    for (const char c : std::string{"abc"}) write(UART, static_cast<unsigned char>(c));
    EXPECT_EQ(read(UART + 0x14) & 0x60, 0u);
    EXPECT_EQ(read(UART + 0x80), 2u) << "the first is on its way";
    wait_ns(CHARACTER_NS + 20);
    EXPECT_EQ(board.printed, "a");
    EXPECT_EQ(read(UART + 0x14) & 0x60, 0u);
    wait_ns(CHARACTER_NS);
    EXPECT_EQ(read(UART + 0x14) & 0x60, 0x20u) << "the last has left the FIFO";
    EXPECT_TRUE(board.hps.uart0.is_sending());
    wait_ns(CHARACTER_NS);
    EXPECT_EQ(board.printed, "abc");
    EXPECT_EQ(read(UART + 0x14) & 0x60, 0x60u);
    EXPECT_FALSE(board.hps.uart0.is_sending());
}

TEST_F(Uart0, ReportsAnOverflowOnce) {
    for (int n = 0; n < 129; ++n) write(UART, 'a');
    EXPECT_EQ(read(UART + 0x7C) & 2, 0u) << "full";
    EXPECT_TRUE(board.said.empty());
    write(UART, 'b');
    write(UART, 'b');
    EXPECT_EQ(board.said.size(), 1u);
    wait_ms(12);
    EXPECT_EQ(board.printed, std::string(129, 'a'));
    write(UART + 0x08, 0);  // without FIFOs: one on its way, and one
    for (const char c : std::string{"xyz"}) write(UART, static_cast<unsigned char>(c));
    wait_ms(1);
    EXPECT_EQ(board.printed, std::string(129, 'a') + "xz");
}

TEST_F(Uart0, AsksForMoreAtTheLevelThatIsChosen) {
    take(194);
    write(UART + 0x08, 0x21);  // a quarter
    write(UART + 0x04, 0x82);
    EXPECT_EQ(read(UART + 0x08) & 0xF, 2u);
    for (int n = 0; n < 129; ++n) write(UART, 'a');
    EXPECT_FALSE(board.irq);
    EXPECT_EQ(read(UART + 0x14) & 0x20, 0x20u) << "full";
    wait_ns(95.5 * 86'400);
    EXPECT_FALSE(board.irq);
    wait_ns(86'400);
    EXPECT_TRUE(board.irq);
    EXPECT_EQ(read(UART + 0x80), 32u);
}

TEST_F(Uart0, OfTheSecondNothingIsSentWithoutADivisor) {
    constexpr std::uint32_t UART1 = 0xFFC03000;
    write(UART1, 'a');
    wait_ms(10);
    EXPECT_EQ(read(UART1 + 0x14) & 0x60, 0u);
}

// ---- GPIO1 --------------------------------------------------------------------------------------

class Gpio1 : public tb::HpsBench {
protected:
    static constexpr std::uint32_t GPIO = 0xFF709000, LED = 1u << 24, KEY = 1u << 25;
};

TEST_F(Gpio1, LightsTheLedWhenItsPinIsAnOutput) {
    write(GPIO, LED);
    EXPECT_FALSE(board.hps.gpio1.led());
    write(GPIO + 4, LED);
    EXPECT_TRUE(board.hps.gpio1.led());
    EXPECT_EQ(read(GPIO) & read(GPIO + 4), LED);
    write(GPIO, 0);
    EXPECT_FALSE(board.hps.gpio1.led());
}

TEST_F(Gpio1, ReadsAPressedKeyAs0) {
    EXPECT_EQ(read(GPIO + 0x50) & KEY, KEY);
    board.hps.gpio1.press_key(true);
    EXPECT_EQ(read(GPIO + 0x50) & KEY, 0u);
}

TEST_F(Gpio1, InterruptsOnTheEdgeThatItIsSetTo) {
    take(197);
    write(GPIO + 0x38, KEY);  // edge, falling
    write(GPIO + 0x30, KEY);
    board.hps.gpio1.press_key(true);
    EXPECT_EQ(acknowledge(), 197u);
    EXPECT_EQ(read(GPIO + 0x40), KEY);
    write(GPIO + 0x4C, KEY);
    EXPECT_EQ(read(GPIO + 0x40), 0u);
    board.hps.gpio1.press_key(false);
    EXPECT_EQ(read(GPIO + 0x40), 0u) << "a rising one";
}

TEST_F(Gpio1, InterruptsWhileALevelIsThere) {
    take(197);
    write(GPIO + 0x30, KEY);  // level, low
    EXPECT_FALSE(board.irq);
    board.hps.gpio1.press_key(true);
    EXPECT_TRUE(board.irq);
    write(GPIO + 0x34, KEY);
    EXPECT_FALSE(board.irq) << "masked";
    write(GPIO + 0x34, 0);
    board.hps.gpio1.press_key(false);
    EXPECT_FALSE(board.irq);
}

// ---- Managers -----------------------------------------------------------------------------------

class Managers : public tb::HpsBench {};

TEST_F(Managers, ShowWhichBridgesAreInReset) {
    EXPECT_EQ(read(0xFFD0501C), 0u) << "none, as the boot loader left it";
    write(0xFFD0501C, 2);
    EXPECT_EQ(board.bridges_in_reset, 2u);
    EXPECT_EQ(read(0xFFD0501C), 2u);
}

TEST_F(Managers, ResetByTheResetManagersControl) {
    write(0xFFD05004, 2);
    EXPECT_EQ(board.resets, 1u);
    EXPECT_EQ(read(0xFFD05000), 1u << 10) << "a warm one, by software";
    write(0xFFD05000, 1u << 10);
    EXPECT_EQ(read(0xFFD05000), 0u);
}

TEST_F(Managers, ShowThatTheFpgaIsInUserMode) {
    EXPECT_EQ(read(0xFF706000) & 7, 4u);
    EXPECT_EQ(read(0xFF706000) >> 3 & 0x1F, 0x0Au) << "MSEL";
    EXPECT_EQ(read(0xFF706850) & 7, 7u) << "nSTATUS, CONF_DONE, INIT_DONE";
}

TEST_F(Managers, HaveTheFpgasConfigurationAsTheBootLoaderLeavesIt) {
    EXPECT_EQ(read(0xFF706004), 0x2C0u) << "32 bits, a data ratio of 8, nothing pulled";
}

TEST_F(Managers, PassTheGeneralPurposeSignals) {
    write(0xFF706010, 0x12345678);
    EXPECT_EQ(board.gpo, 0x12345678u);
    EXPECT_EQ(read(0xFF706010), 0x12345678u);
    board.gpi = 0x9ABCDEF0;
    EXPECT_EQ(read(0xFF706014), 0x9ABCDEF0u);
}

TEST_F(Managers, ReportOnceThatAResetFpgaKeepsItsDesign) {
    write(0xFF706004, 0x2C5);
    EXPECT_EQ(read(0xFF706000) & 7, 1u) << "reset";
    EXPECT_EQ(read(0xFF706850) & 7, 0u);
    write(0xFF706004, 0x2C1);
    EXPECT_EQ(read(0xFF706000) & 7, 2u) << "configuration";
    EXPECT_EQ(read(0xFF706850) & 7, 1u) << "nSTATUS";
    write(0xFF706004, 0x2C5);
    ASSERT_EQ(board.said.size(), 1u);
    EXPECT_NE(board.said[0].find("no bitstream is loaded"), std::string::npos);
}

TEST_F(Managers, DoNotResetTheFpgaWhileTheyHaveNoControl) {
    write(0xFF706004, 0x2C4);
    EXPECT_EQ(read(0xFF706000) & 7, 4u);
    EXPECT_TRUE(board.said.empty());
}

TEST_F(Managers, KeepWhatIsWritten) {
    for (const std::uint32_t address : {0xFFD08060u, 0xFFFEF100u, 0xFFFEC000u}) {
        write(address, 0x1234);
        EXPECT_EQ(read(address), 0x1234u) << std::hex << address;
    }
}

TEST_F(Managers, HaveDoneTheCachesMaintenanceWhenAsked) {
    write(0xFFFEF77C, 0xFFFF);
    EXPECT_EQ(read(0xFFFEF77C), 0u);
}

TEST_F(Managers, KeepTheOnChipRamsBytes) {
    write(0xFFFF0000, 0xCAFE);
    write(0xFFFFFFFC, 0xBEEF);
    EXPECT_EQ(read(0xFFFF0000), 0xCAFEu);
    EXPECT_EQ(read(0xFFFFFFFC), 0xBEEFu);
}

}  // namespace
