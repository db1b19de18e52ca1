// compare.h - two reports of the same checks, of a board and of a simulation, side by side
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace sim {

// One line per difference, "CHECK: DETAIL OF a, DETAIL OF b"; none if both are equal.  `a` and `b`
// are the texts of two report.json.  It compares the checks, by name and detail, and whether the
// run passed.  std::runtime_error, "expected a report with checks, got ...", with `a: ` or `b: `
// replaced by the given names.
std::vector<std::string> differences(std::string_view a, const std::string& name_a,
                                     std::string_view b, const std::string& name_b);

}  // namespace sim
