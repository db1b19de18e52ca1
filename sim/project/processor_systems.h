// processor_systems.h - Platform Designer's systems that have the processor in them.
//
// Such a system is generated here, also where there is the Verilog that Platform Designer has made
// of it, which has the vendor's primitives in it; that is taken where a component is of a kind that
// is not known here.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "sim/verilog/file_finder.h"

namespace sim::project {

// Whether a .qsys has the processor, itself or in a subsystem.
bool has_processor(const std::filesystem::path& system, const FileFinder& finder);

// Whether Platform Designer has made this Verilog of such a system.
bool is_made_of_processor_system(const std::filesystem::path& file, const FileFinder& finder);

// .../synthesis/NAME.qip, which Platform Designer makes of NAME.qsys; nothing: it has not.
std::optional<std::filesystem::path> qip_of_system(const std::filesystem::path& system,
                                                   const FileFinder& finder);

// NAME.qsys for .../synthesis/NAME.qip, which Platform Designer makes of it.  `folder`: from which
// the latter is named.
std::optional<std::filesystem::path> system_of_qip(const std::string& qip,
                                                   const std::filesystem::path& folder,
                                                   const FileFinder& finder);

}  // namespace sim::project
