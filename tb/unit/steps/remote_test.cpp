// remote_test.cpp - press-remote
#include "sim/board/nec_frame.h"
#include "tb/unit/steps/step_bench.h"

namespace {

using namespace tb;

class RemoteSteps : public StepTest {};

TEST_F(RemoteSteps, PressAButtonByItsName) {
    acts("press-remote: volume-up");
    board.wait(sim::SimTime{100'000'000'000});
    const std::vector<std::uint32_t> frame_ns = sim::nec_frame(0x1B);
    ASSERT_EQ(board.remote_ps.size(), frame_ns.size() + 1);
    for (std::size_t n = 0; n < frame_ns.size(); ++n)
        EXPECT_EQ(board.remote_ps[n + 1] - board.remote_ps[n], frame_ns[n] * 1000ull) << n;
    EXPECT_EQ(said("press-remote: mute"), "press mute on the remote control");
}

}  // namespace
