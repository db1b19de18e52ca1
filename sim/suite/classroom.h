// classroom.h - what GitHub Classroom counts of a hand-in: the result that its reporter reads.
#pragma once

#include <string>

#include "sim/suite/results.h"

namespace sim::suite {

// A line of base64, for the output `result` of a workflow's step: a test per scenario with all of
// its points or none, and what was expected and found first.
//
// Source: the action classroom-resources/autograding-grading-reporter, version 1, which adds up
// `score` and `max_score` and prints `name`, `status` and `message`.
std::string to_classroom(const Results& results);

}  // namespace sim::suite
