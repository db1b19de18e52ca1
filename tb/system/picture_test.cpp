// picture_test.cpp - every picture on the monitor is that of the same world, drawn in software.
#include "tb/system/running_program.h"

namespace {

class PictureOnTheMonitor : public tb::RunningProgram {
protected:
    void SetUp() override { ASSERT_NO_FATAL_FAILURE(start()); }
};

TEST_F(PictureOnTheMonitor, IsThatOfTheWorld) {
    for (const char* cap : {"1", "2", "5"}) {
        ASSERT_NO_FATAL_FAILURE(press(cap));
        ASSERT_NO_FATAL_FAILURE(follow(12));
    }
    EXPECT_EQ(replay->world().count, 3u);
}

TEST_F(PictureOnTheMonitor, ShowsBoxesPauseSpeedAndEmptinessOnTheirKeys) {
    ASSERT_NO_FATAL_FAILURE(press("40DF"));
    ASSERT_NO_FATAL_FAILURE(follow(5));
    ASSERT_NO_FATAL_FAILURE(press("BC"));
    EXPECT_TRUE(replay->world().show_boxes);
    EXPECT_TRUE(replay->world().paused);
    EXPECT_EQ(replay->world().count, 0u);
}

TEST_F(PictureOnTheMonitor, IsNewInEveryFrameWithAHundredShapes) {
    ASSERT_NO_FATAL_FAILURE(press("2000000000222222222"));
    ASSERT_EQ(replay->world().count, 100u);
    const std::uint64_t frames = board->monitor.frames();
    const std::uint64_t new_pictures = board->monitor.new_pictures();
    ASSERT_NO_FATAL_FAILURE(follow(24));
    EXPECT_EQ(board->monitor.frames() - frames, 24u);
    EXPECT_EQ(board->monitor.new_pictures() - new_pictures, 24u);
}

TEST_F(PictureOnTheMonitor, IsTheSameWithAnotherAlgorithm) {
    replay->use_the_other_algorithm();
    ASSERT_NO_FATAL_FAILURE(press("2000000F"));
    ASSERT_NO_FATAL_FAILURE(follow(10));
    ASSERT_NO_FATAL_FAILURE(press("A"));
    ASSERT_NO_FATAL_FAILURE(follow(10));
}

}  // namespace
