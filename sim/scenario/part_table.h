// part_table.h - every kind of part that a scenario can hang on the headers
#pragma once

#include <vector>

#include "sim/board/part_plan.h"
#include "sim/scenario/step_form.h"

namespace sim {

using PartForm = Form<PartPlan>;

const std::vector<PartForm>& part_forms();

// Throws Refusal where two parts have one name or one pin.
void check_parts(const std::vector<PartPlan>& parts);

// "a button", for messages.
const char* kind_name(PartPlan::Kind kind);

}  // namespace sim
