// keypad.cpp - the part keypad: where the board's keypad hangs; its steps are of steps/controls.cpp
#include "sim/scenario/part_form.h"

namespace sim {

namespace {

using namespace value_types;

PartPlan keypad(const Values& v) {
    PartPlan part;
    part.pins = pins_of(v, "pins");
    return part;
}

}  // namespace

namespace parts {

PartFamily keypad() {
    return {{
                {"keypad",
                 "The keypad, on other pins than JP1 D7 to D0.",
                 Notation::BOTH,
                 {},
                 {{"pins", EIGHT_PINS, Need::REQUIRED, "",
                   "Its columns from the left and its rows from the top: D7 to D0."}},
                 sim::keypad},
            },
            {}};
}

}  // namespace parts

}  // namespace sim
