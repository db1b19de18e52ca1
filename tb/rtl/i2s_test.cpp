// The audio block's clocks and data at the codec's pins, against the I2S format, without a codec
// model.
//
// A frame is 64 BCLKs; LRCK low is left; the most significant bit is at the second rising edge of
// BCLK after LRCK has moved; 24 bits, then zeros.
#include <bitset>
#include <vector>

#include "Vaudio.h"
#include "regmap.h"
#include "tb/support/random_registers.h"
#include "tb/support/register_bus.h"

namespace {

using namespace regmap;

class I2s : public tb::RegisterBus<Vaudio> {
protected:
    struct Bit {
        bool lrck, data;
    };
    std::vector<Bit> bits;             // at the rising edges of BCLK
    std::vector<std::uint64_t> falls;  // of LRCK, in clocks
    std::uint64_t xck_edges = 0, bclk_rises = 0, stray = 0;
    bool bclk = false, lrck = true, data = false, xck = false;

    static void SetUpTestSuite() { tb::start_with_random_registers(); }
    void SetUp() override {
        dut.i2c_sdat_i = 1;
        dut.aud_adcdat_i = 0;
        reset();
        bits.clear();
        falls.clear();
        stray = 0;
    }
    void after_clock() override {
        const bool rise = dut.aud_bclk_o && !bclk, fall = !dut.aud_bclk_o && bclk;
        if (rise) bits.push_back({dut.aud_daclrck_o != 0, dut.aud_dacdat_o != 0});
        if ((dut.aud_daclrck_o != lrck || dut.aud_dacdat_o != data) && !fall) ++stray;
        if (dut.aud_adclrck_o != dut.aud_daclrck_o) ++stray;
        if (lrck && !dut.aud_daclrck_o) falls.push_back(clocks);
        xck_edges += dut.aud_xck_o != xck;
        bclk_rises += rise;
        bclk = dut.aud_bclk_o;
        lrck = dut.aud_daclrck_o;
        data = dut.aud_dacdat_o;
        xck = dut.aud_xck_o;
    }

    // The data bits of the slot of 32 that begins at bits[first].
    std::bitset<32> slot(std::size_t first) const {
        std::bitset<32> result;
        for (std::size_t i = 0; i < 32; ++i) result[31 - i] = bits.at(first + i).data;
        return result;
    }
    // The first bit of the first whole frame.
    std::size_t frame() const {
        std::size_t i = 1;
        while (!(bits.at(i - 1).lrck && !bits.at(i).lrck)) ++i;
        return i;
    }
};

TEST_F(I2s, ClocksTheCodecAt8138Hertz) {
    clock(10 * 3072);
    for (std::size_t i = 1; i < falls.size(); ++i) EXPECT_EQ(falls[i] - falls[i - 1], 3072u);
    EXPECT_EQ(falls.size(), 10u);
}

TEST_F(I2s, ClocksTheCodecAt48828HertzWhenFast) {
    write(CODEC_RATE, 1);
    clock(3072);
    falls.clear();
    clock(10 * 512);
    for (std::size_t i = 1; i < falls.size(); ++i) EXPECT_EQ(falls[i] - falls[i - 1], 512u);
    EXPECT_EQ(falls.size(), 10u);
}

TEST_F(I2s, GivesXckAHalfOfTheClockAndAFrame64Bclks) {
    clock(3072);
    xck_edges = bclk_rises = 0;
    clock(3072);
    EXPECT_EQ(xck_edges, 3072u);  // 12.5 MHz has an edge a clock
    EXPECT_EQ(bclk_rises, 64u);
    write(CODEC_RATE, 1);
    clock(3072);
    xck_edges = bclk_rises = 0;
    clock(512);
    EXPECT_EQ(xck_edges, 512u);
    EXPECT_EQ(bclk_rises, 64u);
}

TEST_F(I2s, MovesLrckAndDataOnlyWhenBclkFalls) {
    for (const std::uint32_t rate : {0u, 1u, 0u}) {
        write(CODEC_RATE, rate);
        for (std::uint32_t i = 0; i < 20; ++i) {
            write(AUDIO_LEFTDATA, 0x9e3779b9 * i);
            write(AUDIO_RIGHTDATA, 0x85ebca6b * i);
        }
        clock(20 * 3072);
    }
    EXPECT_EQ(stray, 0u);
}

TEST_F(I2s, Has64WholeBclksInAFrameEvenWhereTheRateChanges) {
    for (unsigned when = 0; when < 200; ++when) {
        write(CODEC_RATE, when % 2);
        clock(2501 + when);
    }
    unsigned length = 0;
    bool counting = false;
    for (std::size_t i = frame(); i < bits.size(); ++i) {
        if (bits[i - 1].lrck && !bits[i].lrck) {
            if (counting) {
                ASSERT_EQ(length, 64u);
            }
            counting = true;
            length = 0;
        }
        ++length;
    }
}

TEST_F(I2s, SendsTheTop24BitsOneBclkAfterLrck) {
    while (falls.empty()) clock();
    write(AUDIO_LEFTDATA, 0x800001ff);
    write(AUDIO_RIGHTDATA, 0x123456ff);
    bits.clear();
    clock(2 * 3072);
    const std::size_t first = frame();
    EXPECT_EQ(slot(first), std::bitset<32>{0x80000100u >> 1});
    EXPECT_EQ(slot(first + 32), std::bitset<32>{0x12345600u >> 1});
    EXPECT_TRUE(bits[first + 32].lrck);
}

TEST_F(I2s, SendsEveryBitInItsPlace) {
    for (unsigned bit = 8; bit < 32; ++bit) {
        const std::size_t before = falls.size();
        while (falls.size() == before) clock();
        write(AUDIO_LEFTDATA, 1u << bit);
        write(AUDIO_RIGHTDATA, ~(1u << bit));
        bits.clear();
        clock(2 * 3072);
        const std::size_t first = frame();
        ASSERT_EQ(slot(first), std::bitset<32>{(1u << bit) >> 1});
        ASSERT_EQ(slot(first + 32), std::bitset<32>{(~(1u << bit) & 0xffffff00) >> 1});
    }
}

// The far end moves ADCDAT up to 35 ns after BCLK has fallen: late by one clock here.
TEST_F(I2s, ReadsTheBitsOfAdcdatThatBelongToBclksRisingEdges) {
    for (const std::uint32_t rate : {0u, 1u}) {
        write(CODEC_RATE, rate);
        write(AUDIO_CONTROL, AUDIO_CONTROL_CR_MASK);
        clock(2 * 3072);
        std::size_t frames = falls.size();
        while (falls.size() == frames) clock();
        write(AUDIO_CONTROL, 0);  // the pair of this frame comes in
        const std::uint64_t left = 0xa5c3f1, right = 0x7ffffe;
        const std::uint64_t word = left << (63 - 24) | right << (31 - 24);
        for (int i = 63; i >= 0; --i) {
            dut.aud_adcdat_i = word >> i & 1;
            const std::uint64_t rises = bclk_rises;
            while (bclk_rises == rises) clock();
            while (bclk) clock();  // it falls
            clock();
        }
        while (falls.size() < frames + 2) clock();
        EXPECT_EQ(read(AUDIO_LEFTDATA), 0xa5c3f100u) << "rate " << rate;
        EXPECT_EQ(read(AUDIO_RIGHTDATA), 0x7ffffe00u) << "rate " << rate;
    }
}

}  // namespace
