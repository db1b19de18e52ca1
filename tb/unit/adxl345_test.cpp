// adxl345_test.cpp - the accelerometer against its data sheet
#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

#include "sim/board/adxl345.h"

namespace {

constexpr std::uint8_t THRESH_ACT = 0x24, THRESH_INACT = 0x25, TIME_INACT = 0x26, ACT_INACT = 0x27,
                       THRESH_FF = 0x28, TIME_FF = 0x29, RATE = 0x2C, POWER = 0x2D,
                       INT_ENABLE = 0x2E, INT_MAP = 0x2F, INT_SOURCE = 0x30, FORMAT = 0x31,
                       DATA = 0x32, FIFO = 0x38, FIFO_STATUS = 0x39;
constexpr std::uint8_t MEASURE = 0x08, FULL_RES = 0x08;
constexpr std::uint8_t READY = 0x80, ACTIVITY = 0x10, INACTIVITY = 0x08, FREE_FALL = 0x04,
                       WATERMARK = 0x02, OVERRUN = 0x01;

class Adxl345 : public ::testing::Test {
protected:
    static constexpr std::uint64_t MS_PS = 1'000'000'000;
    sim::Adxl345 chip;
    std::uint64_t now = 0;

    void pass_ms(double ms) { now += static_cast<std::uint64_t>(ms * MS_PS); }
    void set(std::uint8_t number, std::uint8_t value) {
        chip.begin(false);
        chip.write(number, now);
        chip.write(value, now);
        chip.end();
    }
    std::vector<std::uint8_t> get(std::uint8_t number, unsigned count) {
        chip.begin(false);
        chip.write(number, now);
        chip.begin(true);
        std::vector<std::uint8_t> bytes;
        while (count--) bytes.push_back(chip.read(now));
        chip.end();
        return bytes;
    }
    unsigned get(std::uint8_t number) { return get(number, 1)[0]; }
    std::vector<int> axes() {
        const auto b = get(DATA, 6);
        std::vector<int> values;
        for (int i = 0; i < 6; i += 2)
            values.push_back(static_cast<std::int16_t>(b[i] | b[i + 1] << 8));
        return values;
    }
    bool int1() {
        chip.advance(now);
        return chip.int1();
    }
    using Axes = std::vector<int>;
};

TEST_F(Adxl345, IdentifiesItself) { EXPECT_EQ(get(0), 0xE5u); }

TEST_F(Adxl345, HasItsResetValues) {
    EXPECT_EQ(get(RATE), 0x0Au);
    EXPECT_EQ(get(POWER), 0u);
    EXPECT_EQ(get(INT_SOURCE), WATERMARK) << "0 samples of 0";
}

TEST_F(Adxl345, MeasuresNothingInStandby) {
    pass_ms(100);
    EXPECT_EQ(axes(), (Axes{0, 0, 0}));
    EXPECT_EQ(get(INT_SOURCE) & READY, 0u);
}

TEST_F(Adxl345, Measures256StepsPerGLyingFlat) {
    set(POWER, MEASURE);
    pass_ms(10);
    EXPECT_EQ(axes(), (Axes{0, 0, 256}));
}

TEST_F(Adxl345, HasCoarserStepsInAWiderRangeWithoutFullResolution) {
    set(POWER, MEASURE);
    chip.move({0.5, -1, 1}, now);
    for (const unsigned range : {0u, 1u, 2u, 3u}) {
        set(FORMAT, static_cast<std::uint8_t>(range));
        pass_ms(10);
        EXPECT_EQ(axes(), (Axes{128 >> range, -(256 >> range), 256 >> range}));
        set(FORMAT, static_cast<std::uint8_t>(FULL_RES | range));
        pass_ms(10);
        EXPECT_EQ(axes(), (Axes{128, -256, 256}));
    }
}

TEST_F(Adxl345, ClipsAtTheEndOfItsRange) {
    set(POWER, MEASURE);
    chip.move({3, -3, 1}, now);
    pass_ms(10);
    EXPECT_EQ(axes(), (Axes{511, -512, 256}));
    set(FORMAT, FULL_RES | 1);
    pass_ms(10);
    EXPECT_EQ(axes(), (Axes{768, -768, 256}));
}

TEST_F(Adxl345, PutsTheSignificantBitsToTheLeftIfAsked) {
    set(POWER, MEASURE);
    set(FORMAT, 0x04);
    chip.move({0, 0, -1}, now);
    pass_ms(10);
    EXPECT_EQ(axes(), (Axes{0, 0, -256 * 64}));
}

TEST_F(Adxl345, AddsItsOffsets) {
    set(POWER, MEASURE);
    set(0x1E, 64);    // 1 g
    set(0x20, 0xC0);  // -1 g
    pass_ms(10);
    EXPECT_EQ(axes(), (Axes{256, 0, 0}));
}

TEST_F(Adxl345, TakesASampleAtEachPeriodOfItsRate) {
    set(RATE, 0x0D);  // 800 Hz
    set(POWER, MEASURE);
    pass_ms(1.24);
    EXPECT_EQ(get(INT_SOURCE) & READY, 0u);
    pass_ms(0.02);
    EXPECT_EQ(get(INT_SOURCE) & READY, READY);
    chip.move({1, 0, 0}, now);
    EXPECT_EQ(axes(), (Axes{0, 0, 256})) << "of the sample before";
    EXPECT_EQ(get(INT_SOURCE) & READY, 0u) << "it has been read";
    pass_ms(1.25);
    EXPECT_EQ(axes(), (Axes{256, 0, 0}));
}

TEST_F(Adxl345, ReportsWhenASampleWasLost) {
    set(POWER, MEASURE);
    pass_ms(21);
    EXPECT_EQ(get(INT_SOURCE) & OVERRUN, OVERRUN);
    axes();
    EXPECT_EQ(get(INT_SOURCE) & OVERRUN, 0u);
}

TEST_F(Adxl345, KeepsTheFirst33InFifoTheLast33InStreamMode) {
    for (const bool stream : {false, true}) {
        set(FIFO, 0);
        set(POWER, 0);
        axes();
        set(FIFO, stream ? 0x80 : 0x40);
        set(POWER, MEASURE);
        for (int i = 0; i < 40; ++i) {
            chip.move({i / 256.0, 0, 0}, now);
            pass_ms(10);
        }
        EXPECT_EQ(get(FIFO_STATUS), 33u);
        EXPECT_EQ(get(INT_SOURCE) & OVERRUN, OVERRUN);
        for (int i = 0; i < 33; ++i) ASSERT_EQ(axes()[0], i + (stream ? 7 : 0)) << stream;
        EXPECT_EQ(get(FIFO_STATUS), 0u);
    }
}

TEST_F(Adxl345, RaisesItsWatermark) {
    set(FIFO, 0x80 | 4);
    set(INT_ENABLE, WATERMARK);
    set(POWER, MEASURE);
    pass_ms(35);
    EXPECT_FALSE(int1());
    pass_ms(10);
    EXPECT_TRUE(int1());
    axes();
    EXPECT_FALSE(int1());
}

TEST_F(Adxl345, InterruptsAtThePinThatTheMapSays) {
    set(INT_ENABLE, READY);
    set(POWER, MEASURE);
    EXPECT_EQ(chip.next_ps(), now + 10 * MS_PS);
    pass_ms(11);
    EXPECT_TRUE(int1());
    set(INT_MAP, READY);
    EXPECT_FALSE(int1());
    set(INT_MAP, 0);
    set(FORMAT, 0x20);
    EXPECT_FALSE(int1()) << "inverted";
}

TEST_F(Adxl345, NoticesThatItMovesUntilTheSourceIsRead) {
    set(THRESH_ACT, 8);    // 0.5 g
    set(ACT_INACT, 0xF0);  // against how it lay
    set(INT_ENABLE, ACTIVITY);
    set(POWER, MEASURE);
    pass_ms(50);
    EXPECT_FALSE(int1());
    chip.move({0.7, 0, 1}, now);
    pass_ms(10);
    EXPECT_TRUE(int1());
    EXPECT_EQ(get(INT_SOURCE) & ACTIVITY, ACTIVITY);
    EXPECT_FALSE(int1());
}

TEST_F(Adxl345, NoticesThatItLiesStillForSomeSeconds) {
    set(THRESH_INACT, 4);
    set(TIME_INACT, 2);
    set(ACT_INACT, 0x0F);
    set(INT_ENABLE, INACTIVITY);
    set(POWER, MEASURE);
    pass_ms(1980);
    EXPECT_FALSE(int1());
    pass_ms(30);
    EXPECT_TRUE(int1());
}

TEST_F(Adxl345, NoticesThatItFalls) {
    set(THRESH_FF, 5);
    set(TIME_FF, 20);  // 100 ms
    set(INT_ENABLE, FREE_FALL);
    set(POWER, MEASURE);
    chip.move({0, 0, 0.1}, now);
    pass_ms(95);
    EXPECT_FALSE(int1());
    pass_ms(15);
    EXPECT_TRUE(int1());
}

TEST_F(Adxl345, LosesWhatIsWrittenToItsReadOnlyRegisters) {
    for (const std::uint8_t number : {0x00, 0x30, 0x32, 0x39}) {
        const unsigned was = get(number);
        set(number, 0x55);
        EXPECT_EQ(get(number), was) << int{number};
    }
}

}  // namespace
