// monitor.cpp against pin samples made here from the standard's numbers, right and wrong.
#include "sim/board/monitor.h"

#include <gmock/gmock.h>

#include <vector>

#include "sim/fpga/fabric.h"

namespace {

using sim::Monitor;
using ::testing::HasSubstr;

// What a controller sends; each number can be made wrong.
struct Signal {
    unsigned h_total = 800, hs = 96, h_back = 48, h_shown = 640;
    unsigned v_total = 525, vs = 2, v_back = 33, v_shown = 480;
    bool hs_active = false, vs_active = false;  // levels of the pulses
    unsigned vs_late = 0;                       // clocks between the begin of HS and that of VS
    std::uint32_t blanking_colour = 0;

    std::uint32_t at(std::uint64_t clock) const {
        const std::uint64_t x = clock % h_total, y = clock / h_total % v_total;
        const std::uint64_t from_vs = (clock + v_total * h_total - vs_late) % (v_total * h_total);
        const bool in_hs = x < hs, in_vs = from_vs < vs * h_total;
        const bool shown = x >= hs + h_back && x < hs + h_back + h_shown && y >= vs + v_back &&
                           y < vs + v_back + v_shown;
        std::uint32_t pins = shown ? colour(x - hs - h_back, y - vs - v_back) : blanking_colour;
        if (in_hs == hs_active) pins |= sim::video::HS;
        if (in_vs == vs_active) pins |= sim::video::VS;
        if (shown) pins |= sim::video::BLANK_N;
        return pins;
    }
    static std::uint32_t colour(std::uint64_t x, std::uint64_t y) {
        return static_cast<std::uint32_t>((x * 3 + y * 7) % 256 << 16 | x % 256 << 8 | y % 256);
    }
};

class MonitorTest : public ::testing::Test {
protected:
    std::vector<std::vector<std::uint32_t>> pictures;
    std::vector<bool> is_new;
    Monitor monitor{[this](const Monitor::Frame& f) {
        EXPECT_EQ(f.number, pictures.size() + 1);
        pictures.push_back(f.pixels);
        is_new.push_back(f.is_new);
    }};

    // A bit of blanking, then `frames` and a bit more, in batches of odd lengths.
    void show(const Signal& signal, unsigned frames) {
        std::vector<std::uint32_t> pins;
        const std::uint64_t frame = std::uint64_t{signal.h_total} * signal.v_total;
        const std::uint64_t end = frame * (frames + 1) + 2000;
        for (std::uint64_t clock = frame - 3000; clock < end; ++clock) {
            pins.push_back(signal.at(clock));
            if (pins.size() == 777 || clock + 1 == end) {
                monitor.samples(pins.data(), pins.size());
                pins.clear();
            }
        }
    }
    std::string first_message() const {
        return monitor.messages().empty() ? "none" : monitor.messages().front();
    }
};

TEST_F(MonitorTest, FindsThePictureOfAStandardSignal) {
    show({}, 3);
    ASSERT_EQ(pictures.size(), 3u);
    for (unsigned y = 0; y < 480; ++y)
        for (unsigned x = 0; x < 640; ++x)
            ASSERT_EQ(pictures[2][y * 640 + x], Signal::colour(x, y)) << x << "," << y;
    EXPECT_EQ(monitor.violations(), 0u) << first_message();
}

TEST_F(MonitorTest, AcceptsAVsApartFromHs) {
    Signal signal;
    signal.vs_late = 300;
    show(signal, 3);
    EXPECT_EQ(monitor.violations(), 0u) << first_message();
    EXPECT_GE(pictures.size(), 2u);
}

TEST_F(MonitorTest, DistinguishesANewPictureFromARepeatedOne) {
    show({}, 3);
    EXPECT_EQ(is_new, (std::vector<bool>{true, false, false}));
    EXPECT_EQ(monitor.new_pictures(), 1u);
}

TEST_F(MonitorTest, ReportsAWrongLineLength) {
    Signal signal;
    signal.h_total = 799;
    show(signal, 2);
    EXPECT_THAT(first_message(), HasSubstr("line 799 clocks, expected 800"));
}

TEST_F(MonitorTest, ReportsAWrongNumberOfLines) {
    Signal signal;
    signal.v_total = 524;
    show(signal, 3);
    EXPECT_THAT(first_message(), HasSubstr("frame 524 lines, expected 525"));
}

TEST_F(MonitorTest, ReportsAWrongHorizontalSyncWithItsLineAndClock) {
    Signal signal;
    signal.hs = 95;
    signal.h_back = 49;
    show(signal, 2);
    EXPECT_THAT(first_message(), HasSubstr("clock 95: HS low 95 clocks, expected 96"));
}

TEST_F(MonitorTest, ReportsAWrongVerticalSync) {
    Signal signal;
    signal.vs = 3;
    signal.v_back = 32;
    show(signal, 2);
    EXPECT_THAT(first_message(), HasSubstr("VS low 2400 clocks, expected 1600"));
}

TEST_F(MonitorTest, ReportsAWrongHorizontalPorch) {
    Signal signal;
    signal.h_back = 50;
    show(signal, 2);
    EXPECT_THAT(first_message(),
                HasSubstr("picture begins after 146 clocks from HS, expected 144"));
}

TEST_F(MonitorTest, ReportsAWrongVerticalPorch) {
    Signal signal;
    signal.v_back = 30;
    show(signal, 2);
    EXPECT_THAT(first_message(), HasSubstr("picture begins after 32 lines from VS, expected 35"));
}

TEST_F(MonitorTest, ReportsARowOfWrongLength) {
    Signal signal;
    signal.h_shown = 639;
    show(signal, 2);
    EXPECT_THAT(first_message(), HasSubstr("picture row 639 clocks, expected 640"));
}

TEST_F(MonitorTest, ReportsMissingRows) {
    Signal signal;
    signal.v_shown = 479;
    show(signal, 2);
    EXPECT_THAT(first_message(), HasSubstr("picture 479 rows, expected 480"));
}

TEST_F(MonitorTest, ReportsWrongPolarities) {
    Signal horizontal;
    horizontal.hs_active = true;
    show(horizontal, 2);
    EXPECT_THAT(first_message(), HasSubstr("HS low 704 clocks, expected 96"));
    const std::uint64_t so_far = monitor.violations();
    Signal vertical;
    vertical.vs_active = true;
    show(vertical, 2);
    EXPECT_GT(monitor.violations(), so_far);
}

TEST_F(MonitorTest, ReportsColourDuringBlankingOnceALine) {
    Signal signal;
    signal.blanking_colour = 0x000100;
    show(signal, 1);
    EXPECT_THAT(monitor.messages().at(5),
                HasSubstr("frame 1, line 1, clock 0: colour 0x000100 during blanking"));
    EXPECT_LE(monitor.violations(), 535u);
}

TEST_F(MonitorTest, KeepsOnlyTheFirstTwentyMessages) {
    Signal signal;
    signal.h_total = 799;
    show(signal, 2);
    EXPECT_EQ(monitor.messages().size(), 20u);
    EXPECT_GT(monitor.violations(), 1000u);
}

TEST_F(MonitorTest, ShowsNothingWithoutASignal) {
    const std::vector<std::uint32_t> dark(1'000'000, sim::video::HS | sim::video::VS);
    monitor.samples(dark.data(), dark.size());
    EXPECT_TRUE(pictures.empty());
}

}  // namespace
