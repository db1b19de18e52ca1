// committed_system.h - a Platform Designer system of which the generated Verilog is there alone
//
// The processor's bridges are primitives in NAME_fpga_interfaces.sv, of which rtl/ip has models.
// What is outside of the FPGA, the processor's pins and its SDRAM, is left out.
#pragma once

#include <optional>
#include <string>

#include "sim/project/module_files.h"
#include "sim/project/qsys/generate.h"

namespace sim::project {

// The module alone without what is in it, if the file is NAME_hps_io_border.sv; nothing: another.
std::optional<std::string> without_pins(const std::filesystem::path& file, const std::string& text);

// Of the module with the processor's bridges, "NAME_INSTANCE_fpga_interfaces".  The map is that of
// NAME.sopcinfo, and empty without it.
qsys::Generated committed_system(const ModuleFiles& files, const std::string& interfaces);

}  // namespace sim::project
