// selftest_test.cpp - the board's self-test detects errors of a board: registers, memory, clocks.
#include "selftest/checks.h"

#include <gmock/gmock.h>

#include <functional>
#include <map>
#include <string>

namespace {

using ::testing::HasSubstr;

// A mock board that works; a test replaces one part by a faulty one.
class FakeBoard : public hal::Mmio, public hal::Cpu {
public:
    std::map<std::uint32_t, std::uint32_t> kept;
    std::map<std::uint32_t, std::uint32_t> bits;  // that an address has; all if it is not there
    std::map<std::uint32_t, std::function<std::uint32_t()>> answers;
    std::function<std::uint32_t(std::uint32_t)> where = [](std::uint32_t address) {
        return address;
    };
    std::function<void(std::uint32_t, std::uint32_t)> on_write = [](std::uint32_t, std::uint32_t) {
    };
    std::uint32_t now_us = 0;

    std::uint32_t read(std::uint32_t address) override {
        now_us += 1;
        const auto answer = answers.find(address);
        return answer == answers.end() ? kept[where(address)] : answer->second();
    }
    void write(std::uint32_t address, std::uint32_t value) override {
        const auto has = bits.find(address);
        kept[where(address)] = has == bits.end() ? value : value & has->second;
        on_write(address, value);
    }
    void write_words(std::uint32_t address, const std::uint32_t* words, unsigned count) override {
        for (unsigned i = 0; i < count; ++i) write(address + 4 * i, words[i]);
    }
    void idle() override { now_us += 50; }
    std::uint32_t micros() override { return now_us; }
    void print(const char* text) override { printed += text; }

    std::string printed;
};

class SelfTest : public ::testing::Test {
protected:
    FakeBoard board;
    selftest::Bench bench{board, board};

    void unmet(const selftest::Finding& finding, const std::string& why) const {
        EXPECT_FALSE(finding.met);
        EXPECT_THAT(finding.detail, HasSubstr(why));
    }
};

TEST_F(SelfTest, SeesALedThatIsStuck) {
    board.bits[0xFF200000] = 0x3FF;
    EXPECT_TRUE(selftest::ledr(bench).met);
    EXPECT_EQ(board.kept[0xFF200000], 0u);
    board.bits[0xFF200000] = 0x3FE;
    unmet(selftest::ledr(bench), "0x000003FE at 0xFF200000, expected 0x000003FF");
}

TEST_F(SelfTest, SeesABitThatShouldNotBeThere) {
    unmet(selftest::hex5_4(bench), "0xFFFFFFFF at 0xFF200030, expected 0x00007F7F");
}

TEST_F(SelfTest, SeesAnotherBuildsSystemId) {
    board.kept[0xFF202040] = 0x12345678;
    unmet(selftest::system_id(bench), "0x12345678 at 0xFF202040, expected 0x44453153");
    board.kept[0xFF202040] = 0x44453153;
    unmet(selftest::system_id(bench), "at 0xFF202044");
}

TEST_F(SelfTest, SeesACodecThatDoesNotAnswer) {
    board.answers[0xFF205104] = [] { return 2u; };
    unmet(selftest::codec(bench), "0x00000002 at 0xFF205104, expected 0x00000001");
    board.answers[0xFF205104] = [] { return 0u; };  // for ever
    unmet(selftest::codec(bench), "0x00000000");
}

TEST_F(SelfTest, SeesMemoryThatForgetsABit) {
    EXPECT_TRUE(selftest::picture0(bench).met);
    board.bits[0xC8000000 + (239 << 10) + 636] = 0x7FFFFFFF;
    unmet(selftest::picture0(bench), "at 0xC803BE7C");
}

TEST_F(SelfTest, SeesAnAddressLineThatIsShort) {
    board.where = [](std::uint32_t address) { return address & ~(1u << 12); };
    unmet(selftest::picture1(bench), "at 0xC0000000");
}

TEST_F(SelfTest, SeesAPictureThatComesBackChanged) {
    board.answers[0xFF20302C] = [] { return 0u; };
    EXPECT_TRUE(selftest::drawn_picture(bench).met);
    board.bits[0xC0000000 + 640] = 0;  // between the rows: nothing is there
    EXPECT_TRUE(selftest::drawn_picture(bench).met);
    board.bits[0xC0000000 + 636] = 0xFFFF;
    EXPECT_FALSE(selftest::drawn_picture(bench).met);
}

TEST_F(SelfTest, SeesASwapThatNeverTakesPlace) {
    board.answers[0xFF20302C] = [] { return 1u; };
    unmet(selftest::drawn_picture(bench), "never");
}

// VESA's 640 x 480 on a 25 MHz clock: 800 * 525 clocks.
TEST_F(SelfTest, SeesAPixelClockThatIsTwoPercentOff) {
    std::uint32_t frame_us = 16800, asked_us = 0;
    board.on_write = [&](std::uint32_t address, std::uint32_t) {
        if (address == 0xFF203020) asked_us = board.now_us;
    };
    board.answers[0xFF20302C] = [&] {
        return board.now_us / frame_us == asked_us / frame_us ? 1u : 0u;
    };
    EXPECT_TRUE(selftest::frame_rate(bench).met);
    frame_us = 17136;
    unmet(selftest::frame_rate(bench), "expected 16500 to 17100");
}

TEST_F(SelfTest, SeesASampleClockThatIsHalfAsFast) {
    double us_a_sample = 1e6 * 3072 / 25e6;
    double empty_us = 0;
    board.on_write = [&](std::uint32_t address, std::uint32_t) {
        if (address == 0xFF203048)
            empty_us = std::max(empty_us, static_cast<double>(board.now_us)) + us_a_sample;
    };
    board.answers[0xFF203044] = [&] {
        const double left = (empty_us - board.now_us) / us_a_sample;
        const std::uint32_t room = left > 0 ? 128 - static_cast<std::uint32_t>(left + 1) : 128;
        return room << 24 | room << 16;
    };
    EXPECT_TRUE(selftest::sample_rate(bench).met);
    us_a_sample *= 2;
    unmet(selftest::sample_rate(bench), "expected 15000 to 20000");
}

TEST_F(SelfTest, SeesATimerThatNeverEnds) {
    board.answers[0xFF202000] = [] { return 2u; };
    unmet(selftest::interval_timer(bench), "1000000 us, expected 9800 to 15000");
}

TEST_F(SelfTest, WaitsAMinuteForAKeyAndThenReportsWhich) {
    board.answers[0xFF20500C] = [] { return 0u; };
    unmet(selftest::keypad(bench), "1 was not pressed within 60 s");
    EXPECT_GE(board.now_us, 60'000'000u);
}

TEST_F(SelfTest, DetectsAKeypadThatReportsAnotherKey) {
    board.answers[0xFF20500C] = [this] {
        return board.printed.empty() ? 0u : 0x8100u | 4;  // the key "4"
    };
    unmet(selftest::keypad(bench), "4, expected 1");
}

TEST_F(SelfTest, TakesThePersonsNo) {
    unsigned looks = 0;
    board.answers[0xFF200050] = [&] { return ++looks == 2 ? 8u : 0u; };
    unmet(selftest::lamps(bench), "not seen");
    EXPECT_EQ(board.kept[0xFF200000], 0u);
}

}  // namespace
