#include "sim/verilog/nearest.h"

#include <algorithm>
#include <iterator>
#include <tuple>

#include "sim/text/lower.h"

namespace sim::project {

namespace fs = std::filesystem;

std::size_t nearest(const std::vector<fs::path>& files, const fs::path& user,
                    const std::string& module) {
    const fs::path folder = user.parent_path();
    const auto nearness = [&](const fs::path& file) {
        const fs::path other = file.parent_path();
        const auto differ = std::mismatch(folder.begin(), folder.end(), other.begin(), other.end());
        return std::tuple{file == user, other == folder,
                          std::distance(folder.begin(), differ.first),
                          lower(file.stem().string()) == lower(module)};
    };
    const auto best = std::max_element(
        files.begin(), files.end(),
        [&](const fs::path& a, const fs::path& b) { return nearness(a) < nearness(b); });
    return static_cast<std::size_t>(best - files.begin());
}

}  // namespace sim::project
