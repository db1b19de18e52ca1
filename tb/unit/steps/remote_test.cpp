// remote_test.cpp - press-remote
#include "tb/unit/steps/step_bench.h"

namespace {

using namespace tb;
using testing::ElementsAre;

class RemoteSteps : public StepTest {};

TEST_F(RemoteSteps, PressAButtonByItsName) {
    EXPECT_THAT(acts("press-remote: volume-up"), ElementsAre("remote 1B"));
    EXPECT_THAT(acts("press-remote: 5"), ElementsAre("remote 05"));
    EXPECT_EQ(said("press-remote: mute"), "press mute on the remote control");
}

}  // namespace
