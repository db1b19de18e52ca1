// The AD converter's model, word by word, by its datasheet.
#include <gtest/gtest.h>

#include "sim/board/ltc2308.h"

namespace {

class Chip : public ::testing::Test {
protected:
    sim::Ltc2308 chip;
    std::uint64_t now_ps = 1'000'000;

    // One transfer: the result of the conversion that the previous word has chosen.
    int transfer(unsigned word, std::uint64_t patience_ps = sim::Ltc2308::CONVERSION_PS) {
        pins(true, false, false);
        now_ps += patience_ps;
        pins(false, false, false);
        unsigned result = 0;
        for (int bit = 11; bit >= 0; --bit) {
            const bool sdi = bit >= 6 && (word >> (bit - 6) & 1) != 0;
            pins(false, false, sdi);
            result = result << 1 | (chip.sdo() ? 1u : 0u);
            pins(false, true, sdi);
            pins(false, false, sdi);
        }
        now_ps += 240'000;
        return static_cast<int>(result);
    }

    void pins(bool convst, bool sck, bool sdi) {
        chip.drive(convst, sck, sdi, now_ps);
        now_ps += 20'000;
    }
};

TEST_F(Chip, AnswersWithTheChannelThatTheWordBeforeHasChosen) {
    chip.set(0, 1000);
    chip.set(5, 2000);
    transfer(0b100010);
    EXPECT_EQ(transfer(0b111010), 1000);
    EXPECT_EQ(transfer(0b100010), 2000);
}

TEST_F(Chip, TakesWhatWasOnSdiBeforeSckRises) {
    chip.set(0, 1000);
    chip.set(1, 2000);
    constexpr unsigned WORD = 0b110010;  // channel 1
    pins(true, false, false);
    now_ps += sim::Ltc2308::CONVERSION_PS;
    for (int bit = 5; bit >= -6; --bit) {
        pins(false, false, bit >= 0 && (WORD >> bit & 1));
        pins(false, true, bit >= 1 && (WORD >> (bit - 1) & 1));
    }
    pins(false, false, false);
    EXPECT_EQ(transfer(0), 2000);
}

TEST_F(Chip, NumbersItsInputsAsTheDatasheet) {
    constexpr unsigned WORDS[] = {0b100010, 0b110010, 0b100110, 0b110110,
                                  0b101010, 0b111010, 0b101110, 0b111110};
    for (unsigned n = 0; n < 8; ++n) chip.set(n, static_cast<int>(100 + n));
    for (unsigned n = 0; n < 8; ++n) {
        transfer(WORDS[n]);
        EXPECT_EQ(transfer(0), static_cast<int>(100 + n));
    }
}

TEST_F(Chip, ClipsToItsRange) {
    chip.set(1, 5000);
    transfer(0b110010);
    EXPECT_EQ(transfer(0b110010), 4095);
    chip.set(1, -300);
    EXPECT_EQ(transfer(0b110010), 0);
}

TEST_F(Chip, GivesDifferencesInTwosComplement) {
    chip.set(2, 700);
    chip.set(3, 1000);
    transfer(0b000100);  // CH2 - CH3
    EXPECT_EQ(transfer(0b010100), 0xfff & -300);
    EXPECT_EQ(transfer(0b010100), 300) << "CH3 - CH2";
}

TEST_F(Chip, HoldsTheVoltageAsItWasWhenConvstRose) {
    chip.set(0, 1234);
    transfer(0b100010);
    chip.drive(true, false, false, now_ps);
    chip.set(0, 4000);
    now_ps += 2'000'000;
    chip.drive(false, false, false, now_ps);
    EXPECT_FALSE(chip.sdo()) << "1234 begins with 0, 4000 with 1";
}

TEST_F(Chip, LosesAResultThatIsFetchedTooEarly) {
    chip.set(0, 4095);
    transfer(0b100010);
    EXPECT_EQ(transfer(0b100010, 1'000'000), 0);
    EXPECT_GT(chip.disturbed(), 0u);
}

}  // namespace
