// sopcinfo.h - what the .sopcinfo has, which Platform Designer writes beside a system
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "sim/project/qsys/component.h"
#include "sim/project/qsys/interconnect.h"
#include "sim/project/qsys/system.h"

namespace sim::project::qsys {

// Interfaces and ports with this instance's widths; without the module, its files and parameters.
// Nothing: the file has no such instance of that kind.  ProjectError: the file is broken.
std::optional<Component> component_in_sopcinfo(const std::filesystem::path& file,
                                               const Instance& instance);

// What the processor reaches.  ProjectError: the file is broken.
std::vector<Place> map_in_sopcinfo(const std::filesystem::path& file);

}  // namespace sim::project::qsys
