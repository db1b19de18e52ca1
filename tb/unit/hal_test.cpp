// hal/: what the drivers write and how they read, against registers restated from the datasheets.
#include <gmock/gmock.h>

#include <deque>
#include <map>
#include <vector>

#include "hal/audio_out.h"
#include "hal/clock.h"
#include "hal/console.h"
#include "hal/display.h"
#include "hal/keypad.h"
#include "hal/panel.h"
#include "hal/system_id.h"

namespace {

using ::testing::ElementsAre;
using ::testing::Pair;

// Registers as a map; a queue in front of an address answers first.
struct FakeIo : hal::Mmio {
    std::map<std::uint32_t, std::uint32_t> registers;
    std::map<std::uint32_t, std::deque<std::uint32_t>> answers;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> writes;
    std::uint64_t reads = 0;

    std::uint32_t read(std::uint32_t address) override {
        ++reads;
        auto& queue = answers[address];
        if (queue.empty()) return registers[address];
        const std::uint32_t value = queue.front();
        queue.pop_front();
        return value;
    }
    void write(std::uint32_t address, std::uint32_t value) override {
        writes.emplace_back(address, value);
        registers[address] = value;
    }
    void write_words(std::uint32_t address, const std::uint32_t* words, unsigned count) override {
        for (unsigned i = 0; i < count; ++i) writes.emplace_back(address + 4 * i, words[i]);
    }
};

class Hal : public ::testing::Test {
protected:
    FakeIo io;
};

TEST_F(Hal, TheKeypadGivesPressesAsCapsAndPassesOverReleases) {
    hal::Keypad keypad{io};
    EXPECT_THAT(io.writes, ElementsAre(Pair(0xFF205000u, 1u)));
    // Key numbers row by row: 1 2 3 A, 4 5 6 B, 7 8 9 C, 0 F E D.
    io.answers[0xFF20500C] = {0x8100 | 5, 0x8000 | 5, 0x8100 | 12, 0};
    EXPECT_EQ(keypad.pressed(), '5');
    EXPECT_EQ(keypad.pressed(), '0');
    EXPECT_EQ(keypad.pressed(), 0);
}

TEST_F(Hal, TheKeypadEndsEvenIfTheFifoNeverEmpties) {
    hal::Keypad keypad{io};
    struct Stuck : FakeIo {
        std::uint32_t read(std::uint32_t) override { return 0x8003; }  // releases, for ever
    } stuck;
    hal::Keypad other{stuck};
    EXPECT_EQ(other.pressed(), 0);
}

TEST_F(Hal, TheDisplayDrawsIntoTheOtherPictureAfterEachSwap) {
    hal::Display display{io};
    const std::uint32_t words[] = {7, 8};
    io.writes.clear();
    display.write_row(3, 10, words, 2);
    EXPECT_THAT(io.writes, ElementsAre(Pair(0xC0000000u + 3 * 1024 + 40, 7u),
                                       Pair(0xC0000000u + 3 * 1024 + 44, 8u)));
    EXPECT_EQ(display.back(), 1u);
    display.swap();
    io.answers[0xFF20302C] = {0x08090F05, 0x08090F04};
    EXPECT_FALSE(display.swapped());
    EXPECT_TRUE(display.swapped());
    EXPECT_EQ(display.back(), 0u);
    io.writes.clear();
    display.write_row(0, 0, words, 1);
    EXPECT_THAT(io.writes, ElementsAre(Pair(0xC8000000u, 7u)));
}

TEST_F(Hal, AudioHasRoomForTheFullerChannel) {
    hal::AudioOut audio{io};
    io.registers[0xFF203044] = 0x20800000;  // left 32, right 128
    EXPECT_EQ(audio.space(), 32u);
    io.registers[0xFF203044] = 0x80050000;
    EXPECT_EQ(audio.space(), 5u);
    audio.push(-1, 2);
    EXPECT_THAT(io.writes, ElementsAre(Pair(0xFF203048u, 0xffffffffu), Pair(0xFF20304Cu, 2u)));
}

TEST_F(Hal, ThePanelShowsDecimalsWithoutLeadingZeros) {
    hal::Panel panel{io};
    panel.number(0);
    panel.number(105);
    panel.number(123456);
    EXPECT_THAT(io.writes,
                ElementsAre(Pair(0xFF200020u, 0x0000003fu), Pair(0xFF200020u, 0x00063f6du),
                            Pair(0xFF200020u, 0x6f6f6f6fu)));
}

TEST_F(Hal, TheClockCarriesIntoTheHighWord) {
    hal::Clock clock{io};
    clock.start();
    EXPECT_THAT(io.writes, ElementsAre(Pair(0xFFFEC208u, 1u)));
    io.answers[0xFFFEC204] = {0, 1, 1};          // high: wraps between the two reads
    io.answers[0xFFFEC200] = {0xffffffff, 200};  // low
    EXPECT_EQ(clock.micros(), static_cast<std::uint32_t>(((1ull << 32) + 200) / 200));
}

TEST_F(Hal, TheConsoleWaitsForRoomButNotForEver) {
    hal::Console console{io};
    io.answers[0xFFC0207C] = {1, 1, 3};
    console.print("a");
    EXPECT_EQ(io.reads, 3u);
    EXPECT_THAT(io.writes, ElementsAre(Pair(0xFFC02000u, std::uint32_t{'a'})));
    console.print("b");  // full for ever
    EXPECT_LT(io.reads, 200'000u);
}

TEST_F(Hal, TheSystemIdMustMatchTheMap) {
    EXPECT_FALSE(hal::system_id_matches(io));
    io.registers[0xFF202040] = 0x44453153;
    EXPECT_FALSE(hal::system_id_matches(io));
    io.registers[0xFF202044] = regmap::REGMAP_HASH;
    EXPECT_TRUE(hal::system_id_matches(io));
}

// Moving one of these is a change for every program: to be made here, deliberately.
TEST(Regmap, KeepsTheAddressesThatProgramsKnow) {
    EXPECT_EQ(regmap::LEDR_DATA, 0xFF200000u);
    EXPECT_EQ(regmap::HEX3_0_DATA, 0xFF200020u);
    EXPECT_EQ(regmap::SW_DATA, 0xFF200040u);
    EXPECT_EQ(regmap::KEY_EDGE, 0xFF20005Cu);
    EXPECT_EQ(regmap::JP1_DATA, 0xFF200060u);
    EXPECT_EQ(regmap::PIXEL_BUFFER, 0xFF203020u);
    EXPECT_EQ(regmap::AUDIO_CONTROL, 0xFF203040u);
    EXPECT_EQ(regmap::KEYPAD_CONTROL, 0xFF205000u);
    EXPECT_EQ(regmap::KEY_IRQ_ID, 73u);
    EXPECT_EQ(regmap::AUDIO_IRQ_ID, 78u);
    EXPECT_EQ(regmap::JP1_IRQ_ID, 83u);
}

}  // namespace
