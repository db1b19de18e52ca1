// top_module.h - the module that is the top where the settings name none that is there.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "sim/project/board_description.h"
#include "sim/project/module_files.h"

namespace sim::project {

struct TopModule {
    std::string name;
    std::string note;  // for a person: why this one, and which others are possible
};

// The module with the most of the board's pins as ports, of those that no other instances, test
// benches apart.  Nothing: none has any.  ProjectError: two have as many; it names `folder`.
std::optional<TopModule> top_module_by_pins(const ModuleFiles& files,
                                            const std::filesystem::path& folder,
                                            const BoardDescription& board);

}  // namespace sim::project
