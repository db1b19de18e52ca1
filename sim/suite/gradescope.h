// gradescope.h - what Gradescope shows of a hand-in: the results.json of its autograders.
#pragma once

#include <filesystem>
#include <string>

#include "sim/suite/results.h"

namespace sim::suite {

// A test per scenario: all of its points or none; of one that failed, what was expected and found,
// with golden and actual picture, as HTML.  `folder` has the runs.  A scenario that an interruption
// has left without a result is listed as failed, without points.
//
// Source: Gradescope's documentation, Autograder Specifications, "Output Format".
std::string to_gradescope(const std::filesystem::path& folder, const Results& results);

}  // namespace sim::suite
