#include "sim/project/committed_system.h"

#include <algorithm>
#include <regex>

#include "sim/hps/bridge_windows.h"
#include "sim/project/qsys/sopcinfo.h"
#include "sim/project/settings.h"

namespace sim::project {

namespace fs = std::filesystem;

namespace {

bool ends_with(const std::string& text, std::string_view ending) {
    return text.size() >= ending.size() &&
           text.compare(text.size() - ending.size(), ending.size(), ending) == 0;
}

// Bits of the full bridge; 0: it is not used.
unsigned full_width(const std::string& text) {
    static const std::regex SIZE{
        R"(cyclonev_hps_interface_hps2fpga [^;]*port_size_config\(\{\s*2'b([01]{2}))"};
    std::smatch found;
    if (!std::regex_search(text, found, SIZE)) return 0;
    return found[1] == "00" ? 32 : found[1] == "01" ? 64 : found[1] == "10" ? 128 : 0;
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

std::optional<std::string> without_pins(const fs::path& file, const std::string& text) {
    if (!ends_with(file.stem().string(), "_hps_io_border")) return {};
    const std::size_t module = text.find("\nmodule "), end = text.find(");", module);
    if (module == std::string::npos || end == std::string::npos) return {};
    return text.substr(0, end + 2) + "\nendmodule\n";
}

qsys::Generated committed_system(const ModuleFiles& files, const std::string& interfaces) {
    qsys::Generated system;
    system.has_processor = true;
    for (const fs::path& file : files.finder().files()) {
        const std::string name = file.stem().string();
        if (file.extension() != ".sopcinfo" || interfaces.compare(0, name.size() + 1, name + "_"))
            continue;
        system.name = name;
        system.map = qsys::map_in_sopcinfo(file);
    }
    const ModuleFiles::Definition& d = files.modules().at(interfaces);
    const unsigned width = full_width(files.source(d.source).file.whole_text());
    if (width) system.bridges.push_back({H2F_BASE, width, decoded(system.map, H2F_BASE), "", ""});
    if (d.module->wants.count("cyclonev_hps_interface_hps2fpga_light_weight"))
        system.bridges.push_back({LW_BASE, 32, decoded(system.map, LW_BASE), "", ""});
    return system;
}

}  // namespace sim::project
