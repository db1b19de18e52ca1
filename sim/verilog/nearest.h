// nearest.h - of several files that define one module, the one that is meant.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace sim::project {

// Which of `files`, which define `module`, is nearest to `user`: itself, else one in its folder,
// else the one whose folder has the most in common with that of `user`; of several the one that
// has the module's name, else the first.  There is one at least.
std::size_t nearest(const std::vector<std::filesystem::path>& files,
                    const std::filesystem::path& user, const std::string& module);

}  // namespace sim::project
