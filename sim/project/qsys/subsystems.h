// subsystems.h - a Platform Designer system with what is in its subsystems
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "sim/project/qsys/system.h"

namespace sim::project::qsys {

// KIND.qsys, if an instance of that kind is a system itself.
using FindSystem = std::function<std::optional<std::filesystem::path>(const std::string& kind)>;

// The system, with the instances of each subsystem in its place: "vga.dma" is then "vga_dma".
// ProjectError: a file is no such system, a subsystem contains itself, there are more than 10,000
// modules in all, a connection names an interface that a subsystem does not export.
System with_subsystems(const System& system, const FindSystem& find);

}  // namespace sim::project::qsys
