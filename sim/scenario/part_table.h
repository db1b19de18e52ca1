// part_table.h - every kind of part that a scenario can hang on the headers
#pragma once

#include <vector>

#include "sim/scenario/part_form.h"

namespace sim {

// Those of all the files in parts/, in the order of their names.
const std::vector<PartForm>& part_forms();
const std::vector<StepForm>& steps_on_parts();

// Throws Refusal where two parts have one name or one pin.
void check_parts(const std::vector<PartPlan>& parts);

}  // namespace sim
