// video_mode.cpp against X.org's modelines.
#include "sim/board/video_mode.h"

#include <gtest/gtest.h>

#include <utility>

#include "tb/unit/video_modelines.h"

namespace {

using namespace tb;
using sim::nearest_mode;
using sim::VideoMode;
using sim::VideoTiming;

VideoTiming timing_of(const Modeline& m, bool rows_known = true) {
    return {
        m.htotal * 1e6 / m.mhz,  static_cast<double>(m.htotal), m.vtotal, m.hpositive, m.vpositive,
        rows_known ? m.vdisp : 0};
}

// The same in the words of the other.
void expect_same(const VideoMode* found, const Modeline& m) {
    ASSERT_TRUE(found) << m.hdisp << " x " << m.vdisp << " of " << m.vtotal;
    EXPECT_EQ(found->clock_khz, static_cast<unsigned>(m.mhz * 1000 + 0.5));
    const VideoMode::Axis &h = found->h, &v = found->v;
    EXPECT_EQ(h.shown, m.hdisp);
    EXPECT_EQ(h.shown + h.front_porch, m.hsyncstart);
    EXPECT_EQ(h.shown + h.front_porch + h.sync, m.hsyncend);
    EXPECT_EQ(h.total(), m.htotal);
    EXPECT_EQ(h.sync_to_picture(), m.htotal - m.hsyncstart);
    EXPECT_EQ(v.shown, m.vdisp);
    EXPECT_EQ(v.shown + v.front_porch, m.vsyncstart);
    EXPECT_EQ(v.shown + v.front_porch + v.sync, m.vsyncend);
    EXPECT_EQ(v.total(), m.vtotal);
    EXPECT_EQ(h.positive, m.hpositive);
    EXPECT_EQ(v.positive, m.vpositive);
}

TEST(VideoMode, HasTheStandardsNumbers) {
    for (const Modeline& m : MODELINES) {
        expect_same(nearest_mode(timing_of(m)), m);
        expect_same(nearest_mode(timing_of(m, false)), m);
    }
}

TEST(VideoMode, HasTheStandardsRates) {
    const VideoMode* const vga = nearest_mode(timing_of(VGA));
    ASSERT_TRUE(vga);
    EXPECT_NEAR(vga->line_ps(), 31.778e6, 1e3);
    EXPECT_NEAR(vga->frame_hz(), 59.94, 0.01);
}

TEST(VideoMode, IsTheNearestOfTotalsThatDiffer) {
    for (const auto& [clocks, lines] : {std::pair{798u, 523u}, {800u, 521u}, {794u, 528u}}) {
        Modeline m = VGA;
        m.mhz = 25;
        m.htotal = clocks;
        m.vtotal = lines;
        expect_same(nearest_mode(timing_of(m)), VGA);
    }
}

// Their lines take equally long, whatever their clocks.
TEST(VideoMode, IsIdentifiedAmong449LinesByPolarityRowsAndClocks) {
    const auto size_of = [](const VideoTiming& timing) {
        const VideoMode* const mode = nearest_mode(timing);
        return mode ? std::pair{mode->h.shown, mode->v.shown} : std::pair{0u, 0u};
    };
    const VideoTiming text{31.777e6, 800, 449, false, true, 0};
    EXPECT_EQ(size_of(text), std::pair(640u, 400u));
    VideoTiming other = text;
    other.hs_positive = true;
    other.vs_positive = false;
    EXPECT_EQ(size_of(other), std::pair(640u, 350u));
    other.shown_lines = 400;
    EXPECT_EQ(size_of(other), std::pair(640u, 400u));
    other = text;
    other.line_samples = 900;
    EXPECT_EQ(size_of(other), std::pair(720u, 400u));
    other.line_samples = 1800;
    EXPECT_EQ(size_of(other), std::pair(720u, 400u));
}

TEST(VideoMode, IsNoneWhereNoneIsNear) {
    const VideoTiming ntsc{63.5e6, 858, 262, false, false, 240};
    EXPECT_FALSE(nearest_mode(ntsc));
    VideoTiming twice_as_fast = timing_of(VGA);
    twice_as_fast.line_ps /= 2;
    EXPECT_FALSE(nearest_mode(twice_as_fast));
    const VideoTiming square{20e6, 1200, 1190, true, true, 1100};
    EXPECT_FALSE(nearest_mode(square));
}

}  // namespace
