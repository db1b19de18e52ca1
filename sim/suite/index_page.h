// index_page.h - all runs of `de1sim test` on one page of HTML: failures first, then the list
#pragma once

#include <filesystem>
#include <string>

#include "sim/suite/results.h"

namespace sim::suite {

// Pictures and other files are links into `folder`, where results.json is and the page will be.
std::string to_index(const std::filesystem::path& folder, const Results& results);

}  // namespace sim::suite
