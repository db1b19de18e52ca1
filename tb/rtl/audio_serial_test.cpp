// audio_serial.v at the codec's pins, against the I2S format, without a codec model.
//
// A frame is 64 BCLKs; LRCK low is left; the most significant bit is at the second rising edge of
// BCLK after LRCK has moved; 24 bits, then zeros.
#include <gtest/gtest.h>

#include <bitset>
#include <vector>

#include "Vaudio_serial.h"
#include "tb/support/random_registers.h"

namespace {

constexpr unsigned FRAME = 128;  // clocks

class AudioSerial : public ::testing::Test {
protected:
    struct Bit {
        bool lrck, data;
    };
    Vaudio_serial dut;
    std::vector<Bit> bits;        // at the rising edges of BCLK
    std::vector<unsigned> falls;  // of LRCK, in clocks
    std::vector<unsigned> taken;  // clocks in which a pair was
    std::vector<unsigned> received;
    unsigned clocks = 0, stray = 0;

    static void SetUpTestSuite() { tb::start_with_random_registers(); }
    void SetUp() override {
        dut.rst_i = 1;
        dut.waits_i = dut.adcdat_i = 0;
        clock(2);
        dut.rst_i = 0;
        bits.clear();
        falls.clear();
        taken.clear();
        received.clear();
        stray = 0;
    }
    void clock(unsigned count = 1) {
        while (count--) {
            dut.clk_i = 0;
            dut.eval();
            const bool bclk = dut.bclk_o, lrck = dut.lrck_o, data = dut.dacdat_o;
            if (dut.take_o) taken.push_back(clocks);
            if (dut.received_o) received.push_back(clocks);
            dut.clk_i = 1;
            dut.eval();
            ++clocks;
            if (dut.bclk_o && !bclk) bits.push_back({dut.lrck_o != 0, dut.dacdat_o != 0});
            if ((dut.lrck_o != lrck || dut.dacdat_o != data) && !(bclk && !dut.bclk_o)) ++stray;
            if (lrck && !dut.lrck_o) falls.push_back(clocks);
        }
    }
    void send(std::uint32_t left, std::uint32_t right) {
        dut.waits_i = 1;
        dut.pair_i = std::uint64_t{left} << 24 | right;
        for (const std::size_t before = taken.size(); taken.size() == before;) clock();
        dut.waits_i = 0;
    }
    // The data bits of the 32 BCLKs from bits[first] on.
    std::bitset<32> slot(std::size_t first) const {
        std::bitset<32> result;
        for (std::size_t i = 0; i < 32; ++i) result[31 - i] = bits.at(first + i).data;
        return result;
    }
};

TEST_F(AudioSerial, HasAFrameIn128ClocksAnd64Bclks) {
    clock(10 * FRAME);
    ASSERT_EQ(falls.size(), 10u);
    for (std::size_t i = 1; i < falls.size(); ++i) EXPECT_EQ(falls[i] - falls[i - 1], FRAME);
    EXPECT_EQ(bits.size(), 640u);
}

TEST_F(AudioSerial, BeginsAFrameAtTheFirstFallOfBclkAfterReset) {
    for (const unsigned before : {0u, 1u, 2u, 37u}) {  // clocks since the last reset
        SetUp();
        clock(before);
        SetUp();
        EXPECT_EQ(dut.bclk_o, 0);
        EXPECT_EQ(dut.lrck_o, 1);
        EXPECT_EQ(dut.dacdat_o, 0);
        const unsigned end_of_reset = clocks;
        clock(4);
        ASSERT_EQ(falls.size(), 1u);
        EXPECT_EQ(falls[0], end_of_reset + 2) << "BCLK rises, then it falls with LRCK";
    }
}

TEST_F(AudioSerial, MovesLrckAndDataOnlyWhenBclkFalls) {
    for (std::uint32_t i = 1; i < 20; ++i) send(0x9e3779 * i & 0xffffff, 0x85ebca * i & 0xffffff);
    EXPECT_EQ(stray, 0u);
}

TEST_F(AudioSerial, TakesAPairWhenAFrameBegins) {
    clock(10 * FRAME);
    ASSERT_EQ(taken.size(), falls.size());
    for (std::size_t i = 0; i < taken.size(); ++i) EXPECT_EQ(taken[i] + 1, falls[i]);
}

TEST_F(AudioSerial, LeavesTimeForTheNextPairAfterOne) {
    clock(10 * FRAME);
    ASSERT_EQ(received.size(), 10u);
    for (std::size_t i = 0; i + 1 < received.size(); ++i)
        EXPECT_EQ(taken[i + 1] - received[i], 14u);
}

TEST_F(AudioSerial, SendsZerosIfNoPairWaits) {
    dut.pair_i = 0xffffffffffff;
    clock(3 * FRAME);
    for (const Bit& bit : bits) ASSERT_FALSE(bit.data);
}

TEST_F(AudioSerial, Sends24BitsOneBclkAfterLrck) {
    send(0x800001, 0x123456);
    bits.clear();
    clock(FRAME);
    EXPECT_EQ(slot(0), std::bitset<32>{0x80000100u >> 1});
    EXPECT_EQ(slot(32), std::bitset<32>{0x12345600u >> 1});
    EXPECT_FALSE(bits[31].lrck);
    EXPECT_TRUE(bits[32].lrck);
}

TEST_F(AudioSerial, SendsEveryBitInItsPlace) {
    for (unsigned bit = 0; bit < 24; ++bit) {
        send(1u << bit, ~(1u << bit) & 0xffffff);
        bits.clear();
        clock(FRAME - 2);
        bits.resize(64);
        ASSERT_EQ(slot(0), std::bitset<32>{1u << bit << 7});
        ASSERT_EQ(slot(32), std::bitset<32>{(~(1u << bit) & 0xffffff) << 7});
    }
}

// The codec changes ADCDAT after BCLK's fall, and long before it rises.
TEST_F(AudioSerial, SamplesAdcdatAtTheRisingEdgesOfBclk) {
    const std::uint64_t left = 0xa5c3f1, right = 0x7ffffe;
    const std::uint64_t word = left << (63 - 24) | right << (31 - 24);
    while (falls.empty()) clock();
    for (int i = 63; i >= 0; --i) {
        dut.adcdat_i = word >> i & 1;
        clock();  // BCLK rises
        dut.adcdat_i = !dut.adcdat_i;
        clock();
        if (received.size() == 1) break;
    }
    ASSERT_EQ(received.size(), 1u);
    EXPECT_EQ(std::uint64_t{dut.pair_o}, left << 24 | right);
}

}  // namespace
