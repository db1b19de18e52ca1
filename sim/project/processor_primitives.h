// processor_primitives.h - the processor in a design that instances the device's primitives itself
//
// cyclonev_hps_interface_hps2fpga and its kind are where the processor meets the FPGA; rtl/ip has
// models of them.  A person's own Verilog names them, or that which Platform Designer has made of a
// system whose .qsys is not there (NAME_fpga_interfaces.sv).  What is outside of the FPGA, the
// processor's pins and its SDRAM, is left out.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "sim/project/module_files.h"
#include "sim/project/qsys/generate.h"

namespace sim::project {

bool is_processor_primitive(const std::string& module);

// The module alone without what is in it, if the file is NAME_hps_io_border.sv; nothing: another.
std::optional<std::string> without_pins(const std::filesystem::path& file, const std::string& text);

// Of a module that instances primitives.  If it is Platform Designer's, "NAME_fpga_interfaces", the
// map is that of NAME.sopcinfo; without that, or in another module, the map is empty.
qsys::Generated processor_of_primitives(const ModuleFiles& files, const std::string& module);

}  // namespace sim::project
