// The HPS's DMA controller and its SPI controllers, at their registers, in the on-chip RAM.
#include <gmock/gmock.h>

#include "tb/sim/hps_bench.h"

namespace {

class Dma : public tb::HpsBench {
protected:
    static constexpr std::uint32_t DMA = 0xFFE01000, INTEN = DMA + 0x20, EVENTS = DMA + 0x24,
                                   INTCLR = DMA + 0x2C, FAULTS = DMA + 0x34, TYPE = DMA + 0x40,
                                   STATUS = DMA + 0x100, RAM = 0xFFFF0000, CODE = RAM + 0x800;
    static constexpr std::uint32_t EXECUTING = 1, WAITS_FOR_EVENT = 4, WAITS = 7, FAULTING = 15;
    // Both increment, bursts of 4 words.
    static constexpr std::uint32_t WORDS = 1 | 2 << 1 | 3 << 4 | 1 << 14 | 2 << 15 | 3 << 18;

    std::vector<std::uint8_t> code;

    void op(std::initializer_list<unsigned> bytes) {
        for (const unsigned byte : bytes) code.push_back(static_cast<std::uint8_t>(byte));
    }
    void mov(unsigned reg, std::uint32_t value) {
        op({0xBC, reg, value & 0xFF, value >> 8 & 0xFF, value >> 16 & 0xFF, value >> 24});
    }
    void go(unsigned channel = 0, std::uint32_t at = CODE) {
        for (std::size_t i = 0; i < code.size(); ++i)
            write(at + static_cast<std::uint32_t>(i), code[i], 1);
        write(DMA + 0xD08, 0xA0u << 16 | channel << 24);
        write(DMA + 0xD0C, at);
        write(DMA + 0xD04, 0);
    }
    std::uint32_t status(unsigned channel = 0) { return read(STATUS + 8 * channel) & 0xF; }
    void fill(std::uint32_t at, unsigned bytes) {
        for (unsigned i = 0; i < bytes; i += 4) write(at + i, 0x1000 * i + i + 1);
    }
};

TEST_F(Dma, CopiesMemoryInALoopOfBursts) {
    fill(RAM, 256);
    mov(0, RAM);
    mov(2, RAM + 0x400);
    mov(1, WORDS);
    op({0x20, 15, 0x04, 0x08, 0x38, 2});  // 16 times: load, store
    op({0x00});
    go();
    EXPECT_EQ(status(), EXECUTING);
    wait_ms(1);
    EXPECT_EQ(status(), 0u);
    for (unsigned i = 0; i < 256; i += 4) ASSERT_EQ(read(RAM + 0x400 + i), 0x1000 * i + i + 1) << i;
    EXPECT_EQ(read(RAM + 0x500), 0u) << "and no more";
    EXPECT_EQ(read(DMA + 0x400), RAM + 256) << "source";
    EXPECT_EQ(read(DMA + 0x404), RAM + 0x500) << "destination";
}

TEST_F(Dma, RunsLoopsInLoops) {
    mov(2, RAM);
    mov(1, 1 << 14);                                       // bytes
    op({0x20, 2, 0x22, 4, 0x0C, 0x3C, 1, 0x38, 5, 0x00});  // 3 x 5 zeros
    for (unsigned i = 0; i < 20; i += 4) write(RAM + i, 0xFFFFFFFF);
    go();
    wait_ms(1);
    EXPECT_EQ(read(RAM + 8), 0u);
    EXPECT_EQ(read(RAM + 12), 0xFF000000u);
}

TEST_F(Dma, InterruptsByAnEventThatIsEnabled) {
    take(136 + 3);
    write(INTEN, 1 << 3);
    op({0x34, 3 << 3, 0x00});
    go();
    wait_ms(0.01);
    EXPECT_EQ(acknowledge(), 136u + 3);
    write(INTCLR, 1 << 3);
    end(136 + 3);
    EXPECT_FALSE(board.irq);
}

TEST_F(Dma, LetsAChannelWaitForAnothersEvent) {
    op({0x36, 2 << 3, 0x34, 5 << 3, 0x00});
    go(1);
    wait_ms(0.01);
    EXPECT_EQ(status(1), WAITS_FOR_EVENT);
    code.clear();
    op({0x34, 2 << 3, 0x00});
    go(4, CODE + 0x100);
    wait_ms(0.01);
    EXPECT_EQ(status(1), 0u);
    EXPECT_EQ(read(EVENTS), 1u << 5);
}

TEST_F(Dma, AddsToAddressesBothWays) {
    mov(0, 0x100);
    mov(2, 0x100);
    op({0x54, 0x34, 0x12, 0x5E, 0xFC, 0xFF, 0x00});
    go();
    wait_ms(0.01);
    EXPECT_EQ(read(DMA + 0x400), 0x1334u);
    EXPECT_EQ(read(DMA + 0x404), 0xFCu);
}

TEST_F(Dma, FaultsAtWhatIsNoInstructionAndWhereNobodyAnswers) {
    take(144);
    op({0xFF});
    go(2);
    wait_ms(0.01);
    EXPECT_EQ(status(2), FAULTING);
    EXPECT_EQ(read(FAULTS), 1u << 2);
    EXPECT_EQ(read(TYPE + 8), 1u);
    EXPECT_TRUE(board.irq);
    write(DMA + 0xD08, 1 | 2u << 8 | 1u << 16);  // DMAKILL of the channel
    write(DMA + 0xD04, 0);
    EXPECT_EQ(status(2), 0u);
    EXPECT_FALSE(board.irq);
    code.clear();
    mov(0, 0xC1000000);
    mov(1, WORDS);
    op({0x04, 0x00});
    go(2);
    wait_ms(0.01);
    EXPECT_EQ(read(TYPE + 8), 1u << 18) << "a load";
}

TEST_F(Dma, ReportsThatItWaitsForAPeripheral) {
    op({0x31, 9 << 3, 0x00});
    go();
    wait_ms(0.01);
    EXPECT_EQ(status(), WAITS);
    ASSERT_EQ(board.said.size(), 1u);
    EXPECT_NE(board.said[0].find("peripheral 9"), std::string::npos);
}

// ---- SPI ----------------------------------------------------------------------------------------

class Spi : public tb::HpsBench {
protected:
    static constexpr std::uint32_t SPI = 0xFFF00000, ENABLE = SPI + 8, SLAVES = SPI + 0x10,
                                   DIVIDER = SPI + 0x14, TXFLR = SPI + 0x20, RXFLR = SPI + 0x24,
                                   STATUS = SPI + 0x28, RAW = SPI + 0x34, DATA = SPI + 0x60;
    void start() {
        write(DIVIDER, 200);  // 1 MHz
        write(ENABLE, 1);
        write(SLAVES, 1);
    }
};

TEST_F(Spi, SendsAFrameInTheTimeOfItsBits) {
    start();
    write(DATA, 0xA5);
    write(DATA, 0x5A);
    EXPECT_EQ(read(STATUS) & 1, 1u) << "busy";
    wait_ns(8'100);
    EXPECT_EQ(read(RXFLR), 1u);
    wait_ns(8'000);
    EXPECT_EQ(read(STATUS), 0xEu) << "idle, frames have come";
    EXPECT_EQ(read(DATA), 0u) << "nobody is there";
    read(DATA);
    EXPECT_EQ(read(RAW) & 4, 0u);
    read(DATA);
    EXPECT_EQ(read(RAW) & 4, 4u) << "none was left";
}

TEST_F(Spi, HoldsItsFramesUntilASlaveIsSelected) {
    write(DIVIDER, 200);
    write(ENABLE, 1);
    for (int i = 0; i < 257; ++i) write(DATA, 1);
    wait_ms(10);
    EXPECT_EQ(read(TXFLR), 256u);
    EXPECT_EQ(read(RAW) & 2, 2u) << "one was too many";
    write(SLAVES, 1);
    wait_ms(10);
    EXPECT_EQ(read(TXFLR), 0u);
}

TEST_F(Spi, ReceivesAloneAsManyFramesAsAreSet) {
    write(SPI, 2 << 8 | 7);
    write(SPI + 4, 9);
    start();
    write(DATA, 0);
    wait_ms(1);
    EXPECT_EQ(read(RXFLR), 10u);
}

}  // namespace
