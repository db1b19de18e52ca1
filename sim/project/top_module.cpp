#include "sim/project/top_module.h"

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "sim/verilog/project_error.h"

namespace sim::project {

std::optional<TopModule> top_module_by_pins(const ModuleFiles& files,
                                            const std::filesystem::path& folder,
                                            const BoardDescription& board) {
    std::set<std::string> instanced;
    for (const auto& [name, d] : files.modules())
        if (!d.module->ports.empty())  // a test bench has none
            instanced.insert(d.module->wants.begin(), d.module->wants.end());
    std::vector<std::pair<std::size_t, std::string>> candidates;  // number of pins, name
    for (const auto& [name, d] : files.modules()) {
        if (instanced.count(name) || d.module->is_package) continue;
        const auto& ports = d.module->ports;
        const auto count = std::count_if(ports.begin(), ports.end(), [&](const auto& port) {
            return board.signal(port) != nullptr;
        });
        if (count > 0) candidates.emplace_back(static_cast<std::size_t>(count), name);
    }
    if (candidates.empty()) return {};
    std::sort(candidates.rbegin(), candidates.rend());
    const auto& [pins, name] = candidates[0];
    std::string others;
    for (std::size_t i = 1; i < candidates.size() && i < 6; ++i)
        others += (others.empty() ? "; also possible: " : ", ") + candidates[i].second;
    if (candidates.size() > 1 && pins == candidates[1].first)
        throw ProjectError{fmt::format("{}: two top modules are possible, choose by --top: {}{}",
                                       folder.string(), name, others)};
    return TopModule{name, fmt::format("the top module is taken to be {}, which has {} of the "
                                       "board's pins{}",
                                       name, pins, others)};
}

}  // namespace sim::project
