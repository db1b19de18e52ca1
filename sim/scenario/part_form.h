// part_form.h - how a part is written in a scenario file, and what a file of parts/ is made of
//
// A file of parts/ is a family of parts with the steps on them: NAME.cpp defines parts::NAME().
#pragma once

#include <vector>

#include "sim/board/part_plan.h"
#include "sim/scenario/step_form.h"

namespace sim {

// `make` fills in what is on the pins; reader.cpp adds kind, name and place.
using PartForm = Form<PartPlan>;

struct PartFamily {
    std::vector<PartForm> parts;
    std::vector<StepForm> steps;
};

// Of a field of the types below.
HeaderPinList pins_of(const Values& values, const std::string& field);

// By which steps call it.  A part without this field is named as its kind.
Field part_name();

namespace value_types {

// One pin; 1 to 32; 1 to 5; eight.
extern const ValueType PART_PIN, PART_PINS, NUMBER_PINS, EIGHT_PINS;
extern const ValueType PIN_LEVEL;  // low or high

}  // namespace value_types

}  // namespace sim
