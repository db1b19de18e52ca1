// generate.h - the Verilog of a Platform Designer system: its modules, and what is between them
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "sim/hps/pixel_buffer.h"
#include "sim/project/qsys/assembly.h"
#include "sim/project/qsys/devices.h"
#include "sim/project/qsys/interconnect.h"

namespace sim::project::qsys {

struct Generated {
    std::string text;  // of the system's module
    // Of the modules that the vendor's generator makes of instances: SYSTEM_INSTANCE.
    std::map<std::string, std::string> instance_modules;
    std::vector<std::filesystem::path> sources;  // of its components
    std::vector<Place> map;
    std::vector<Bridge> bridges;
    std::vector<std::string> notes;
    bool has_processor;
    std::vector<Device> devices;  // that the processor reaches
    std::string name;             // of the system
    std::optional<PixelBuffer> pixels;
};

// ProjectError: an unknown kind, a slave whose base is not a multiple of its span, two at one
// address, an interrupt that two senders have, a connection of interfaces that are not there.
Generated generate(const System& system, const Describe& describe);

}  // namespace sim::project::qsys
