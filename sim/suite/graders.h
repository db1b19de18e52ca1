// graders.h - results as those who grade read them: GitHub Classroom, Gradescope, a spreadsheet
#pragma once

#include <filesystem>
#include <string>

#include "sim/suite/results.h"

namespace sim::suite {

// GitHub Classroom, what its reporter counts: a line of base64, for the output `result` of a
// workflow's step.  A test per scenario with all of its points or none, and what was expected and
// found first.
//
// Source: the action classroom-resources/autograding-grading-reporter, version 1, which adds up
// `score` and `max_score` and prints `name`, `status` and `message`.
std::string to_classroom(const Results& results);

// Gradescope, the results.json of its autograders: a test per scenario, all of its points or none;
// of one that failed, what was expected and found, with golden and actual picture, as HTML.
// `folder` has the runs.  A scenario that an interruption has left without a result is listed as
// failed, without points.
//
// Source: Gradescope's documentation, Autograder Specifications, "Output Format".
std::string to_gradescope(const std::filesystem::path& folder, const Results& results);

// A spreadsheet, CSV (RFC 4180), a row for each hand-in:
//
//   hand-in, points, of, then each scenario with its points, and what was expected and found first
//
// A cell that a spreadsheet would take for a formula begins with an apostrophe, since programs of
// strangers have written what is in it.  The results' names are HAND-IN/SCENARIO.  A scenario
// without a result has no points.
std::string to_csv(const Results& results);

}  // namespace sim::suite
