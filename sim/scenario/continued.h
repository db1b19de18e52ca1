// continued.h - a scenario with more steps after its own, as the text of a file in another folder.
//
// All that the file has is in it, but for comments, and for `duration` where there are steps: the
// run is as long as they are.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "sim/scenario/scenario.h"

namespace sim {

// `steps` are YAML, one per line.  Files that the scenario names are named as seen from `folder`.
std::string continued(const Scenario& scenario, std::uint64_t seed,
                      const std::filesystem::path& folder, const std::vector<std::string>& steps);

}  // namespace sim
