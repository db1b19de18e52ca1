// junit.h - junit.xml of many runs: a suite per scenario, as its run has written it
#pragma once

#include <filesystem>
#include <string>

#include "sim/suite/results.h"

namespace sim::suite {

// The run's own suite, under the name of the scenario; one with an error where there is none.  Of a
// run that failed with the files that it left, as attachments: [[ATTACHMENT|path]], which GitLab
// and Jenkins show.  Paths begin in `folder`, that of results.json.
std::string junit_suite(const std::filesystem::path& folder, const Result& result);

// Files of a run that did not pass: differing pictures, waveforms, console.  Relative to `folder`.
std::vector<std::filesystem::path> attachments(const std::filesystem::path& folder,
                                               const Result& result);

// Of these the pictures "expected", "actual" or "difference" of a failure.
std::vector<std::filesystem::path> pictures_of(const std::filesystem::path& folder,
                                               const Result& result, const Failure& failure,
                                               const std::string& what);

}  // namespace sim::suite
