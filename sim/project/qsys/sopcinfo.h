// sopcinfo.h - a component as the .sopcinfo has it, which Platform Designer writes beside a system
#pragma once

#include <filesystem>
#include <optional>

#include "sim/project/qsys/component.h"
#include "sim/project/qsys/system.h"

namespace sim::project::qsys {

// Interfaces and ports with this instance's widths; without the module, its files and parameters.
// Nothing: the file has no such instance of that kind.  ProjectError: the file is broken.
std::optional<Component> component_in_sopcinfo(const std::filesystem::path& file,
                                               const Instance& instance);

}  // namespace sim::project::qsys
