// keyboard_test.cpp - type-keys
#include "tb/unit/steps/step_bench.h"

namespace {

using namespace tb;
using testing::ElementsAre;

class KeyboardSteps : public StepTest {};

TEST_F(KeyboardSteps, TypeWhatAKeyboardHas) {
    EXPECT_THAT(acts("type-keys: \"Hi!\\n\""), ElementsAre("keys Hi!\n"));
    EXPECT_EQ(said("type-keys: 'Hi!'"), "type \"Hi!\" on the keyboard");
}

}  // namespace
