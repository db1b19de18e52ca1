// voltage_test.cpp - set-voltage
#include "tb/unit/steps/step_bench.h"

namespace {

using namespace tb;
using testing::ElementsAre;

class VoltageSteps : public StepTest {};

TEST_F(VoltageSteps, SetAChannelToVolts) {
    EXPECT_THAT(acts("set-voltage: {channel: 7, volts: 1.25}"), ElementsAre("CH7 1.25 V"));
    EXPECT_EQ(said("set-voltage: {channel: 0, volts: 3}"), "apply 3 V to CH0");
}

}  // namespace
