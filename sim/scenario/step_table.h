// step_table.h - every step of the language, and every field of a scenario file
#pragma once

#include <vector>

#include "sim/scenario/step_form.h"

namespace sim {

// Those of all the files in steps/ and parts/.
const std::vector<StepForm>& step_forms();

// The fields of the file itself; at least one of `steps` and `duration` has to be there.
const std::vector<Field>& file_fields();

}  // namespace sim
