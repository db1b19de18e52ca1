#include "sim/project/processor_primitives.h"

#include <algorithm>

#include "sim/hps/bridge_windows.h"
#include "sim/project/qsys/sopcinfo.h"

namespace sim::project {

namespace fs = std::filesystem;

namespace {

bool ends_with(const std::string& text, std::string_view ending) {
    return text.size() >= ending.size() &&
           text.compare(text.size() - ending.size(), ending.size(), ending) == 0;
}

// As many addresses as the vendor's interconnect decodes: up to the end of the highest slave.
std::uint64_t decoded(const std::vector<qsys::Place>& map, std::uint32_t window) {
    std::uint64_t end = 1, all = 1;
    for (const qsys::Place& place : map)
        if (place.window == window) end = std::max(end, place.base + place.span);
    while (all < end) all *= 2;
    return all;
}

}  // namespace

bool is_processor_primitive(const std::string& module) {
    return module.compare(0, 23, "cyclonev_hps_interface_") == 0;
}

std::optional<std::string> without_pins(const fs::path& file, const std::string& text) {
    if (!ends_with(file.stem().string(), "_hps_io_border")) return {};
    const std::size_t module = text.find("\nmodule "), end = text.find(");", module);
    if (module == std::string::npos || end == std::string::npos) return {};
    return text.substr(0, end + 2) + "\nendmodule\n";
}

qsys::Generated processor_of_primitives(const ModuleFiles& files, const std::string& module) {
    qsys::Generated system;
    system.has_processor = true;
    if (!ends_with(module, "_fpga_interfaces")) return system;
    for (const fs::path& file : files.finder().files()) {
        const std::string name = file.stem().string();
        if (file.extension() != ".sopcinfo" || module.compare(0, name.size() + 1, name + "_"))
            continue;
        system.name = name;
        system.map = qsys::map_in_sopcinfo(file);
    }
    for (const std::uint32_t window : {H2F_BASE, LW_BASE})
        system.bridges.push_back({window, decoded(system.map, window), "", ""});
    system.notes.push_back(
        "the Verilog that Platform Designer has made of this system is taken as it is");
    return system;
}

}  // namespace sim::project
