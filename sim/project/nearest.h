// nearest.h - of several files that define one module, the one that is meant.
#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

namespace sim::project {

// Which of `files` is the nearest to `user`: itself, else one in its folder, else the one whose
// folder has the most in common with that of `user`; of several the first.  There is one at least.
std::size_t nearest(const std::vector<std::filesystem::path>& files,
                    const std::filesystem::path& user);

}  // namespace sim::project
