// monitor.cpp, tolerant: the picture of whatever signal comes.
#include <fmt/format.h>

#include "tb/unit/video_pins.h"

namespace {

using namespace tb;
using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;
using testing::StartsWith;
using Blank = VideoPins::Blank;

class MonitorModes : public MonitorBench {};

class MonitorMode : public MonitorBench, public ::testing::WithParamInterface<Modeline> {};

// Three begins of frames to lock, then a frame.
constexpr unsigned LOCKED = 4;

TEST_P(MonitorMode, IsFoundByBlankN) {
    VideoPins video;
    video.mode = GetParam();
    show(video, LOCKED);
    EXPECT_EQ(size(), std::pair(video.mode.hdisp, video.mode.vdisp));
    EXPECT_EQ(wrong_pixels(), 0u);
    ASSERT_EQ(reported.size(), 1u);
    EXPECT_THAT(reported[0], StartsWith(fmt::format("{} x {} at ", size().first, size().second)));
    EXPECT_THAT(reported[0],
                EndsWith(fmt::format("{} x {} clocks", video.mode.htotal, video.mode.vtotal)));
}

TEST_P(MonitorMode, IsFoundWithoutBlankN) {
    VideoPins video;
    video.mode = GetParam();
    video.blank = Blank::HIGH;
    show(video, LOCKED);
    EXPECT_EQ(size(), std::pair(video.mode.hdisp, video.mode.vdisp));
    EXPECT_EQ(wrong_pixels(), 0u);
    ASSERT_EQ(reported.size(), 1u);
    EXPECT_THAT(reported[0], EndsWith("clocks, BLANK_N ignored: never low"));
}

INSTANTIATE_TEST_SUITE_P(Standard, MonitorMode, ::testing::ValuesIn(MODELINES), [](auto& mode) {
    const Modeline& m = mode.param;
    return fmt::format("{}x{}of{}at{}MHz", m.hdisp, m.vdisp, m.vtotal, unsigned(m.mhz));
});

// GTF's 1680 x 1050; 1024 x 600 in about the time of 800 x 600; 1184 x 700; 720 x 480 at 27 MHz.
TEST_F(MonitorModes, FollowBlankNWhereNoneIsStandard) {
    for (const Modeline& odd :
         {Modeline{147.14, 1680, 1784, 1968, 2256, 1050, 1051, 1054, 1087, false, true},
          Modeline{51.2, 1024, 1064, 1168, 1344, 600, 601, 604, 635, false, false},
          Modeline{69.7, 1184, 1240, 1360, 1536, 700, 703, 709, 728, true, false},
          Modeline{27, 720, 736, 798, 858, 480, 489, 495, 525, false, false}}) {
        VideoPins video;
        video.mode = odd;
        monitor.clock_ps(1);
        show(video, LOCKED);
        EXPECT_EQ(size(), std::pair(odd.hdisp, odd.vdisp));
        EXPECT_EQ(wrong_pixels(), 0u) << odd;
        EXPECT_THAT(reported.back(),
                    EndsWith(fmt::format("{} x {} clocks", odd.htotal, odd.vtotal)));
    }
}

TEST_F(MonitorModes, HaveFalseColoursWithColoursInThePorches) {
    VideoPins video;
    video.blank = Blank::HIGH;
    video.fault = [](std::uint64_t clock, std::uint32_t pins) {
        return clock % 800 == 760 ? pins | 0x808080 : pins;  // in the back porch
    };
    show(video, LOCKED + 2);
    ASSERT_EQ(reported.size(), 2u);
    EXPECT_THAT(reported[1],
                StartsWith("colours before the picture begins, where BLANK_N is high"));
    EXPECT_EQ(wrong_pixels(), 0u);
}

TEST_F(MonitorModes, AreReportedInALine) {
    VideoPins video;
    video.mode.mhz = 25;
    show(video, LOCKED);
    EXPECT_THAT(reported,
                ElementsAre("640 x 480 at 59.5 Hz, HS and VS negative, 800 x 525 clocks"));
    EXPECT_EQ(monitor.signal(), reported[0]);
}

TEST_F(MonitorModes, AreFoundInAnyPolarity) {
    for (const bool h : {false, true})
        for (const bool v : {false, true}) {
            VideoPins video;
            video.mode.hpositive = h;
            video.mode.vpositive = v;
            video.blank = Blank::HIGH;
            show(video, LOCKED + 6);
            EXPECT_EQ(wrong_pixels(), 0u) << h << v;
            const char* const names[] = {"negative", "positive"};
            EXPECT_THAT(reported.back(),
                        HasSubstr(h == v ? fmt::format("HS and VS {}", names[h])
                                         : fmt::format("HS {}, VS {}", names[h], names[v])));
        }
    EXPECT_EQ(reported.size(), 4u);
}

TEST_F(MonitorModes, MayHaveOtherTotals) {
    VideoPins video;
    video.mode = {25, 640, 656, 752, 798, 480, 490, 492, 523, false, false};
    show(video, LOCKED);
    EXPECT_EQ(size(), std::pair(640u, 480u));
    EXPECT_EQ(wrong_pixels(), 0u);
    EXPECT_THAT(reported,
                ElementsAre("640 x 480 at 59.9 Hz, HS and VS negative, 798 x 523 clocks"));
}

// The picture begins 2 clocks and 2 lines before the standard's.
TEST_F(MonitorModes, AreCutAndPaddedWithBlackByTheStandardsPorches) {
    VideoPins video;
    video.mode = {25, 640, 656, 752, 798, 480, 490, 492, 523, false, false};
    video.blank = Blank::HIGH;
    show(video, LOCKED);
    EXPECT_EQ(size(), std::pair(640u, 480u));
    EXPECT_EQ(wrong_pixels([](unsigned x, unsigned y) {
                  return x < 638 && y < 478 ? VideoPins::colour(x + 2, y + 2) : 0;
              }),
              0u);
}

TEST_F(MonitorModes, AreBlackWhereTheSignalEndsBeforeThem) {
    VideoPins video;
    video.mode = {25, 640, 640, 736, 780, 480, 480, 482, 510, false, false};
    video.blank = Blank::HIGH;
    show(video, LOCKED);
    EXPECT_EQ(wrong_pixels([](unsigned x, unsigned y) {
                  return x < 636 && y < 475 ? VideoPins::colour(x + 4, y + 5) : 0;
              }),
              0u);
}

TEST_F(MonitorModes, AreFoundThoughBlankNIsNeverHigh) {
    VideoPins video;
    video.blank = Blank::LOW;
    show(video, LOCKED);
    EXPECT_EQ(wrong_pixels(), 0u);
    EXPECT_THAT(reported[0], EndsWith("BLANK_N ignored: never high, with which the board's ADV7123 "
                                      "shows black"));
}

TEST_F(MonitorModes, HaveTheSizeThatBlankNShows) {
    VideoPins video;
    video.blank = Blank::WINDOW;
    video.window_w = 636;
    video.window_h = 478;
    show(video, LOCKED);
    EXPECT_EQ(size(), std::pair(636u, 478u));
    EXPECT_EQ(wrong_pixels(), 0u);
    EXPECT_THAT(reported, ElementsAre(StartsWith("636 x 478 at ")));
}

TEST_F(MonitorModes, IgnoreABlankNSizeFarFromThem) {
    VideoPins video;
    video.blank = Blank::SYNCS;
    show(video, LOCKED);
    EXPECT_EQ(size(), std::pair(640u, 480u));
    EXPECT_EQ(wrong_pixels(), 0u);
    EXPECT_THAT(reported, ElementsAre(EndsWith("size: high for 704 x 523")));
}

TEST_F(MonitorModes, AreBlackWhereBlankNIsLow) {
    VideoPins video;
    video.blank = Blank::WINDOW;
    video.window_w = 512;
    video.window_h = 384;
    show(video, LOCKED);
    EXPECT_EQ(size(), std::pair(640u, 480u));
    EXPECT_EQ(wrong_pixels([](unsigned x, unsigned y) {
                  return x < 512 && y < 384 ? VideoPins::colour(x, y) : 0;
              }),
              0u);
}

TEST_F(MonitorModes, TakeTheLineNearestToVs) {
    for (const int late : {0, 1, 144, 300, -1, -16, -300}) {
        VideoPins video;
        video.blank = Blank::HIGH;
        video.vs_late = late;
        show(video, LOCKED + 4);
        EXPECT_EQ(wrong_pixels(), 0u) << late;
    }
}

struct Sampling {
    double mhz, sample_mhz;
    const char* text;
};

TEST_F(MonitorModes, AreResampledAtTheMiddleOfThePixels) {
    for (const Blank blank : {Blank::PICTURE, Blank::HIGH})
        for (const auto& [mhz, sample_mhz, text] :
             {Sampling{25, 50, "800 x 525 clocks, 2 samples per pixel"},
              Sampling{25.175, 50, "800 x 525 clocks, 1.986 samples per pixel"},
              // Most lines have 1588 samples, an even number, but not all.
              Sampling{25.1857, 50, "800 x 525 clocks, 1.985 samples per pixel"},
              // All lines have 1587 samples, an odd number.
              Sampling{40'000 / 1587.0, 50, "800 x 525 clocks, 1.984 samples per pixel"},
              Sampling{25.175, 100, "800 x 525 clocks, 3.972 samples per pixel"},
              Sampling{25.175, 40, "800 x 525 clocks, 1.589 samples per pixel"}}) {
            VideoPins video;
            video.mode.mhz = mhz;
            video.sample_mhz = sample_mhz;
            video.blank = blank;
            monitor.clock_ps(1);  // which has it forget the signal before
            show(video, LOCKED);
            EXPECT_EQ(size(), std::pair(640u, 480u)) << sample_mhz;
            EXPECT_EQ(wrong_pixels(), 0u) << sample_mhz;
            EXPECT_THAT(reported.back(), HasSubstr(text));
        }
}

TEST_F(MonitorModes, HaveWholeSamplesPerPixel) {
    VideoPins video;
    video.mode = {25, 640, 656, 752, 790, 480, 490, 492, 525, false, false};
    video.sample_mhz = 50;
    show(video, LOCKED);
    EXPECT_EQ(size(), std::pair(640u, 480u));
    EXPECT_EQ(wrong_pixels(), 0u);
    EXPECT_THAT(reported, ElementsAre(HasSubstr("790 x 525 clocks, 2 samples per pixel")));
}

TEST_F(MonitorModes, MayBeSampledMoreSlowlyThanTheirPixels) {
    VideoPins video;
    video.mode = SVGA;
    video.sample_mhz = 20;
    show(video, LOCKED);
    EXPECT_EQ(size(), std::pair(800u, 600u));
    EXPECT_EQ(wrong_pixels([](unsigned x, unsigned y) { return VideoPins::colour(x / 2 * 2, y); }),
              0u);
}

}  // namespace
