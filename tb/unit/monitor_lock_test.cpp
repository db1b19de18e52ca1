// monitor.cpp: when it locks on to a signal, when it loses it, and what it says without one.
#include "tb/unit/video_pins.h"

namespace {

using namespace tb;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::StartsWith;
using Blank = VideoPins::Blank;
constexpr std::uint64_t MS = 1'000'000'000;  // in ps

class MonitorLock : public MonitorBench {
protected:
    // Levels that stay, at 25 MHz.
    void hold(std::uint32_t pins, unsigned ms) {
        monitor.clock_ps(40'000);
        const std::vector<std::uint32_t> samples(25'000, pins);
        for (unsigned i = 0; i < ms; ++i) monitor.samples(samples.data(), samples.size());
    }
};

TEST_F(MonitorLock, TakesTwoFramesThatAreAlikeAndShowsTheThird) {
    show({}, 3);  // of which the first two are whole
    EXPECT_EQ(reported.size(), 1u);
    EXPECT_THAT(pictures, IsEmpty());
}

TEST_F(MonitorLock, ShowsEachFrameAndWhichPictureIsNew) {
    show({}, 7);
    EXPECT_EQ(is_new, (std::vector<bool>{true, false, false, false}));  // of the frames 4 to 7
    EXPECT_EQ(monitor.frames(), 4u);
    EXPECT_EQ(monitor.new_pictures(), 1u);
    EXPECT_EQ(monitor.violations(), 0u);
}

TEST_F(MonitorLock, FollowsAChangeOfModeAndShowsNothingInBetween) {
    show({}, 5);
    const std::size_t before = pictures.size();
    VideoPins other;
    other.mode = SVGA;
    show(other, 8);
    ASSERT_EQ(reported.size(), 2u);
    EXPECT_THAT(reported[1], StartsWith("800 x 600 at 60.3 Hz, HS and VS positive"));
    EXPECT_GE(pictures.size(), before + 2);
    for (std::size_t i = before; i < pictures.size(); ++i) EXPECT_EQ(pictures[i].width, 800u);
    EXPECT_EQ(wrong_pixels(), 0u);
    EXPECT_TRUE(is_new[before]);
}

TEST_F(MonitorLock, FollowsAChangeOfModeAtOneClock) {
    VideoPins first, second;
    first.mode.mhz = second.mode.mhz = first.sample_mhz = second.sample_mhz = 50;
    first.mode = {50, 800, 856, 976, 1040, 600, 637, 643, 666, true, true};
    second.mode = {50, 1280, 1312, 1472, 1600, 480, 490, 492, 525, false, false};  // 640, twice
    show(first, 5);
    second.blank = Blank::HIGH;
    const std::size_t before = pictures.size();
    show(second, 12);
    ASSERT_EQ(reported.size(), 2u);
    EXPECT_THAT(reported[0], StartsWith("800 x 600 at 72.2 Hz"));
    EXPECT_THAT(reported[1],
                StartsWith("640 x 480 at 59.5 Hz, HS and VS negative, 800 x 525 clocks, "
                           "2 samples per pixel"));
    for (std::size_t i = before; i < pictures.size(); ++i) EXPECT_EQ(pictures[i].width, 640u);
    EXPECT_GT(pictures.size(), before);
}

TEST_F(MonitorLock, SurvivesAGlitchOfHsInEachFrame) {
    for (const Blank blank : {Blank::PICTURE, Blank::HIGH}) {
        VideoPins video;
        video.blank = blank;
        const std::uint64_t frame = video.mode.clocks();
        show(video, 4);
        video.fault = [frame](std::uint64_t clock, std::uint32_t pins) {
            return clock % frame == 100 * 800 + 300 ? pins ^ sim::video::HS : pins;
        };
        const std::size_t before = pictures.size();
        show(video, 6);
        EXPECT_GE(pictures.size(), before + 4);
        EXPECT_EQ(wrong_pixels(), 0u);
    }
    EXPECT_EQ(reported.size(), 2u);  // with BLANK_N and without
}

TEST_F(MonitorLock, SurvivesAPictureThatShrinksByAPixel) {
    VideoPins video;
    const std::uint64_t frame = video.mode.clocks();
    video.fault = [frame](std::uint64_t clock, std::uint32_t pins) {
        const std::uint64_t x = clock % 800, y = clock % frame / 800;
        const bool edge = clock / frame >= 5 && clock / frame % 2 && (x == 639 || y == 479);
        return edge ? pins & ~sim::video::BLANK_N : pins;
    };
    show(video, 10);
    EXPECT_EQ(reported.size(), 1u);
    EXPECT_EQ(pictures.size(), 7u);
}

TEST_F(MonitorLock, SurvivesLinesWithoutTheirPictureWhichIsBlackThen) {
    VideoPins video;
    const std::uint64_t frame = video.mode.clocks();
    show(video, 4);
    video.fault = [frame](std::uint64_t clock, std::uint32_t pins) {
        const std::uint64_t x = clock % 800, y = clock % frame / 800;
        const bool gone = y == 479 || (y == 100 && x >= 300);
        return gone ? pins & ~sim::video::BLANK_N : pins;
    };
    show(video, 5);
    EXPECT_EQ(reported.size(), 1u);
    EXPECT_EQ(wrong_pixels([](unsigned x, unsigned y) {
                  return y == 479 || (y == 100 && x >= 300) ? 0 : VideoPins::colour(x, y);
              }),
              0u);
}

TEST_F(MonitorLock, ReportsOnceThatASignalIsOutOfRange) {
    VideoPins ntsc;
    ntsc.mode = {13.5, 720, 736, 799, 858, 240, 243, 246, 262, false, false};
    show(ntsc, 8);
    EXPECT_THAT(reported,
                ElementsAre("out of range: 15.7 kHz, 60.1 Hz, HS and VS negative, 262 lines"));
    EXPECT_THAT(pictures, IsEmpty());
}

TEST_F(MonitorLock, DescribesAMissingSignalAfterASecond) {
    hold(sim::video::HS, 300);
    hold(sim::video::HS | sim::video::VS, 100);
    hold(sim::video::HS, 100);
    hold(sim::video::HS | sim::video::VS, 100);
    const std::vector<std::uint32_t> white(12'000, sim::video::HS | sim::video::VS | 0xFFFFFF);
    monitor.samples(white.data(), white.size());
    hold(sim::video::HS | sim::video::VS, 399);
    EXPECT_THAT(reported, IsEmpty());
    hold(sim::video::HS | sim::video::VS, 1);
    EXPECT_THAT(reported, ElementsAre("no signal: HS never moved; VS moved 3 times; VGA_R/G/B were "
                                      "not 0 in 12,000 samples"));
    hold(sim::video::HS | sim::video::VS, 3000);
    EXPECT_EQ(reported.size(), 1u);
    EXPECT_EQ(monitor.signal(), reported[0]);
    EXPECT_THAT(pictures, IsEmpty());
}

TEST_F(MonitorLock, ReportsThatThereAreNoSamplesAtAll) {
    monitor.idle(999 * MS);
    EXPECT_THAT(reported, IsEmpty());
    monitor.idle(1000 * MS);
    monitor.idle(500 * MS);
    monitor.idle(5000 * MS);
    EXPECT_THAT(reported, ElementsAre("no signal: not one sample, VGA_CLK does not rise"));
}

TEST_F(MonitorLock, CountsIdleTimeAndThatOfSamplesTogether) {
    monitor.idle(900 * MS);
    monitor.idle(100 * MS);
    hold(0, 99);
    EXPECT_THAT(reported, IsEmpty());
    hold(0, 1);
    EXPECT_EQ(reported.size(), 1u);
}

TEST_F(MonitorLock, ReportsWhereTheSignalHasGoneAndLocksAnew) {
    VideoPins video;
    video.mode.mhz = 25;
    show(video, 5);
    hold(sim::video::HS | sim::video::VS, 1050);
    EXPECT_EQ(reported.size(), 1u);
    hold(sim::video::HS | sim::video::VS, 100);
    ASSERT_EQ(reported.size(), 2u);
    EXPECT_THAT(reported[1], StartsWith("no signal: HS never moved; VS never moved; VGA_R/G/B were "
                                        "always 0"));
    show(video, 6);
    ASSERT_EQ(reported.size(), 3u);
    EXPECT_EQ(reported[2], reported[0]);
    EXPECT_EQ(wrong_pixels(), 0u);
}

TEST_F(MonitorLock, ReportsThatASignalIsNotSteady) {
    for (unsigned i = 0; i < 40; ++i) {
        VideoPins video;
        video.mode.vtotal = 500 + 20 * (i % 2);
        show(video, 1);
        show(video, 1);
    }
    EXPECT_THAT(reported, ElementsAre(StartsWith("no steady signal: HS moved ")));
}

}  // namespace
