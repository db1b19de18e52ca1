// words.h - what the translator (Verilator) says of a design, in Quartus' numbers and our words.
#pragma once

#include <string>
#include <string_view>

#include "sim/verilog/quartus/message.h"

namespace sim::project {

// Of one error, "top.v:3:5: Can't find definition of variable: 'x'", and the lines after it, which
// have the place in the source and hints: "top.v:3: Quartus error 10161: x is not declared ...".
std::string error_in_our_words(const std::string& error, std::string_view after);

// Of all that it says: 10027, 10037, 10230, 10232, 10236, 12010, 12020, 12030.
Messages warnings_in_our_words(const std::string& output);

}  // namespace sim::project
