// monitor.cpp, strict: what it says of signals that are not VESA's 640 x 480.
#include "tb/unit/video_pins.h"

namespace {

using namespace tb;
using testing::Contains;
using testing::Each;
using testing::HasSubstr;

class StrictMonitor : public MonitorBench {
protected:
    StrictMonitor() : MonitorBench{sim::Monitor::Strictness::STRICT} {}
};

TEST_F(StrictMonitor, FindsThePictureOfAStandardSignal) {
    show({}, 3);
    EXPECT_EQ(size(), std::pair(640u, 480u));
    EXPECT_EQ(wrong_pixels(), 0u);
    EXPECT_EQ(is_new, (std::vector<bool>{true, false}));
    EXPECT_EQ(monitor.new_pictures(), 1u);
    EXPECT_EQ(monitor.violations(), 0u);
}

TEST_F(StrictMonitor, AcceptsAVsApartFromHs) {
    VideoPins video;
    video.vs_late = 300;
    show(video, 3);
    EXPECT_EQ(monitor.violations(), 0u);
    EXPECT_GE(pictures.size(), 2u);
}

struct Wrong {
    const char* name;
    Modeline mode;
    const char* message;
};
void PrintTo(const Wrong& wrong, std::ostream* out) { *out << wrong.name; }

class WrongSignal : public StrictMonitor, public ::testing::WithParamInterface<Wrong> {};

TEST_P(WrongSignal, IsReported) {
    VideoPins video;
    video.mode = GetParam().mode;
    show(video, 3);
    EXPECT_THAT(monitor.messages(), Contains(HasSubstr(GetParam().message)));
}

// clang-format off
const Wrong SIGNALS[] = {
    {"Line", {25, 640, 655, 751, 799, 480, 490, 492, 525, false, false},
     "line 799 clocks, expected 800"},
    {"Frame", {25, 640, 656, 752, 800, 480, 489, 491, 524, false, false},
     "frame 524 lines, expected 525"},
    {"Hs", {25, 640, 656, 751, 800, 480, 490, 492, 525, false, false},
     "clock 95: HS low 95 clocks, expected 96"},
    {"Vs", {25, 640, 656, 752, 800, 480, 490, 493, 525, false, false},
     "VS low 2400 clocks, expected 1600"},
    {"HorizontalPorch", {25, 640, 654, 750, 800, 480, 490, 492, 525, false, false},
     "picture begins after 146 clocks from HS, expected 144"},
    {"VerticalPorch", {25, 640, 656, 752, 800, 480, 493, 495, 525, false, false},
     "picture begins after 32 lines from VS, expected 35"},
    {"Row", {25, 639, 656, 752, 800, 480, 490, 492, 525, false, false},
     "picture row 639 clocks, expected 640"},
    {"Rows", {25, 640, 656, 752, 800, 479, 490, 492, 525, false, false},
     "picture 479 rows, expected 480"},
    {"PolarityOfHs", {25, 640, 656, 752, 800, 480, 490, 492, 525, true, false},
     "HS low 704 clocks, expected 96"},
    {"PolarityOfVs", {25, 640, 656, 752, 800, 480, 490, 492, 525, false, true},
     "VS low 418400 clocks, expected 1600"},
};
// clang-format on

INSTANTIATE_TEST_SUITE_P(Of, WrongSignal, ::testing::ValuesIn(SIGNALS),
                         [](const auto& wrong) { return wrong.param.name; });

TEST_F(StrictMonitor, ReportsColourDuringBlankingOnceALine) {
    VideoPins video;
    video.fault = [](std::uint64_t, std::uint32_t pins) {
        return pins & sim::video::BLANK_N ? pins : pins | 0x000100;
    };
    show(video, 1);
    EXPECT_THAT(monitor.messages(), Each(HasSubstr("colour 0x000100 during blanking")));
    EXPECT_GT(monitor.violations(), 525u);
    EXPECT_LE(monitor.violations(), 632u) << "lines in 1.2 frames";
}

TEST_F(StrictMonitor, KeepsOnlyTheFirstTwentyMessages) {
    VideoPins video;
    video.mode.htotal = 799;
    show(video, 2);
    EXPECT_EQ(monitor.messages().size(), 20u);
    EXPECT_GT(monitor.violations(), 1000u);
}

TEST_F(StrictMonitor, ShowsNothingWithoutASignal) {
    const std::vector<std::uint32_t> dark(1'000'000, sim::video::HS | sim::video::VS);
    monitor.samples(dark.data(), dark.size());
    EXPECT_TRUE(pictures.empty());
}

TEST_F(StrictMonitor, ShowsNoOtherSizeButSaysWhatTheSignalIs) {
    VideoPins video;
    video.mode = SVGA;
    show(video, 4);
    for (const Picture& picture : pictures) EXPECT_EQ(picture.width, 640u);
    EXPECT_GE(pictures.size(), 3u);
    EXPECT_GT(monitor.violations(), 1000u);
    EXPECT_EQ(monitor.signal(), "800 x 600 at 60.3 Hz, HS and VS positive, 1056 x 628 clocks");
}

}  // namespace
