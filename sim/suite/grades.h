// grades.h - a table of hand-ins for a spreadsheet: CSV (RFC 4180), a row for each
//
//   hand-in, points, of, then each scenario with its points, and what was expected and found first
//
// A cell that a spreadsheet would take for a formula begins with an apostrophe, since programs of
// strangers have written what is in it.
#pragma once

#include <string>

#include "sim/suite/results.h"

namespace sim::suite {

// The results' names are HAND-IN/SCENARIO.  A scenario without a result has no points.
std::string to_csv(const Results& results);

}  // namespace sim::suite
