#include "sim/project/qsys/devices.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <set>

#include <fmt/format.h>

namespace sim::project::qsys {

namespace {

constexpr unsigned FIRST_INTERRUPT[] = {72, 104};  // of f2h_irq0 and f2h_irq1
constexpr unsigned FIRST_SPI = 32;                 // from which on a device tree counts them

std::vector<unsigned> interrupts_of(const Assembly& assembly, const std::string& instance) {
    std::vector<unsigned> all;
    for (const Connection& c : assembly.connections()) {
        if (c.kind != Connection::Kind::INTERRUPT || instance_of(c.end) != instance) continue;
        const auto receiver = assembly.find_end(c.start);
        if (!receiver || !receiver->is_processors()) continue;
        all.push_back(FIRST_INTERRUPT[receiver->interface->name == "f2h_irq1"] + c.interrupt);
    }
    std::sort(all.begin(), all.end());
    return all;
}

std::vector<std::string> compatible_of(const End& e) {
    const auto assigned = [&](const char* name) {
        const auto found = e.component->assignments.find(std::string{"embeddedsw.dts."} + name);
        return found == e.component->assignments.end() ? std::string{} : found->second;
    };
    std::vector<std::string> all;
    const std::string listed = assigned("compatible");
    for (std::size_t at = 0; (at = listed.find_first_not_of(" \t\n", at)) != std::string::npos;) {
        const std::size_t end = std::min(listed.find_first_of(" \t\n", at), listed.size());
        all.push_back(listed.substr(at, end - at));
        at = end;
    }
    if (const std::string vendor = assigned("vendor"), name = assigned("name");
        !vendor.empty() && !name.empty()) {
        const std::string own = vendor + "," + name + "-";
        for (const std::string& version : {e.instance->version, e.component->version})
            if (!version.empty() && std::find(all.begin(), all.end(), own + version) == all.end())
                all.push_back(own + version);
    }
    // As the vendor's generator of device trees; of a component that nothing describes the vendor
    // may be any, which sw/kmod/kmod.c takes for the driver's.
    const bool is_described = e.component->file.extension() == ".tcl";
    if (all.empty())
        all.push_back(fmt::format("{},{}-{}", is_described ? "unknown" : "?", e.instance->kind,
                                  e.instance->version));
    return all;
}

std::string upper(std::string text) {
    for (char& c : text)
        c = std::isalnum(static_cast<unsigned char>(c))
                ? static_cast<char>(std::toupper(static_cast<unsigned char>(c)))
                : '_';
    return text;
}

bool is_number(const std::string& text) {
    char* end = nullptr;
    std::strtoll(text.c_str(), &end, 0);
    return !text.empty() && *end == '\0';
}

}  // namespace

std::vector<Device> devices_of(const Assembly& assembly, const std::vector<Place>& map) {
    std::map<std::string, std::set<std::string>> slaves;  // by instance
    for (const Place& place : map)
        if (place.window) slaves[instance_of(place.slave)].insert(place.slave);
    std::vector<Device> all;
    for (const Place& place : map) {
        if (!place.window) continue;
        const End e = assembly.end(place.slave);
        Device d{e.instance->name,
                 e.instance->kind,
                 e.interface->name,
                 slaves[e.instance->name].size() == 1,
                 place.window,
                 place.base,
                 place.span,
                 interrupts_of(assembly, e.instance->name),
                 compatible_of(e),
                 "",
                 {}};
        constexpr std::string_view MACRO = "embeddedsw.CMacro.";
        for (const auto& [name, value] : e.component->assignments) {
            if (name.compare(0, MACRO.size(), MACRO) == 0)
                d.macros[name.substr(MACRO.size())] = value;
            if (name == "embeddedsw.dts.group") d.group = value;
        }
        all.push_back(std::move(d));
    }
    std::stable_sort(all.begin(), all.end(), [](const Device& a, const Device& b) {
        return a.window + a.base < b.window + b.base;
    });
    return all;
}

namespace {

unsigned long number_of(const End& e, const char* parameter) {
    const std::string& value = e.component->parameters.at(parameter);  // 640, 32'h1000
    const std::size_t base = value.find('\'');
    return base == std::string::npos
               ? std::stoul(value)
               : std::stoul(value.substr(base + 2), nullptr, value[base + 1] == 'h' ? 16 : 10);
}

std::optional<PixelBuffer> of_pixel_buffer(const End& master, const std::vector<Place>& map) {
    const auto number = [&](const char* parameter) {
        return static_cast<unsigned>(number_of(master, parameter));
    };
    const unsigned bytes = number("BYTES");
    if (bytes < 2) return {};  // levels of grey, or 256 colours
    unsigned columns = 1;      // X-Y: each line is a power of two
    while (columns < number("WIDTH")) columns *= 2;
    const unsigned line = bytes * (number("CONSECUTIVE") ? number("WIDTH") : columns);
    PixelBuffer pixels{0,    number("WIDTH"),        number("HEIGHT"), bytes == 2 ? 16u : 32u,
                       line, line * number("HEIGHT")};
    const std::uint64_t start = number_of(master, "START");
    for (const Place& its : map)
        for (const Place& ours : map)
            if (its.master == master.name() && start - its.base < its.span && ours.window &&
                ours.slave == its.slave) {
                pixels.base =
                    static_cast<std::uint32_t>(ours.window + ours.base + (start - its.base));
                return pixels;
            }
    return {};
}

// The board's driver (altvipfb) has 32 MB of memory below that of other drivers.
std::optional<PixelBuffer> of_frame_reader(const End& master, const std::vector<Place>& map) {
    constexpr std::uint32_t MEMORY = 0x3C000000;
    const auto number = [&](const char* parameter) {
        return static_cast<unsigned>(number_of(master, parameter));
    };
    for (const Place& place : map)
        if (place.window && place.slave == master.instance->name + ".avalon_slave")
            return PixelBuffer{MEMORY,
                               number("MAX_IMAGE_WIDTH"),
                               number("MAX_IMAGE_HEIGHT"),
                               32,
                               4 * number("MAX_IMAGE_WIDTH"),
                               4 * number("MAX_IMAGE_WIDTH") * number("MAX_IMAGE_HEIGHT"),
                               static_cast<std::uint32_t>(place.window + place.base),
                               number("MEM_PORT_WIDTH")};
    return {};
}

}  // namespace

std::optional<PixelBuffer> pixel_buffer_of(const Assembly& assembly,
                                           const std::vector<Place>& map) {
    std::optional<PixelBuffer> found;
    assembly.for_each([&](const End& e) {
        if (found) return;
        if (e.instance->kind == "altera_up_avalon_video_pixel_buffer_dma" &&
            e.interface->name == "avalon_pixel_dma_master")
            found = of_pixel_buffer(e, map);
        if (e.instance->kind == "alt_vip_vfr" && e.interface->name == "avalon_master")
            found = of_frame_reader(e, map);
    });
    return found;
}

std::string header_text(const std::string& system, const std::vector<Device>& devices) {
    std::string text = fmt::format(
        "// Made by de1sim of {0}.qsys: what the processor reaches in the FPGA.\n"
        "// A base counts from the bridge's first address: 0xFF200000 of the lightweight one,\n"
        "// 0xC0000000 of the other.\n#ifndef HPS_0_H\n#define HPS_0_H\n",
        system);
    for (const Device& d : devices) {
        const std::string prefix =
            upper(d.is_only_slave ? d.instance : d.instance + "_" + d.slave) + "_";
        const auto line = [&](const char* name, const std::string& value) {
            text += fmt::format("#define {}{} {}\n", prefix, name, value);
        };
        text += fmt::format("\n// {}.{}, at 0x{:08X} of the processor\n", d.instance, d.slave,
                            d.window + d.base);
        line("COMPONENT_TYPE", d.kind);
        line("COMPONENT_NAME", d.instance);
        line("BASE", fmt::format("0x{:x}", d.base));
        line("SPAN", std::to_string(d.span));
        line("END", fmt::format("0x{:x}", d.base + d.span - 1));
        if (!d.interrupts.empty())
            line("IRQ", std::to_string(d.interrupts.front() - FIRST_INTERRUPT[0]));
        for (const auto& [name, value] : d.macros)
            line(upper(name).c_str(), is_number(value) ? value : '"' + value + '"');
    }
    return text + "\n#endif\n";
}

std::string device_tree_text(const std::vector<Device>& devices) {
    std::string text;
    for (std::size_t n = 0; n < devices.size(); ++n) {
        const Device& d = devices[n];
        if (n && devices[n - 1].instance == d.instance) continue;  // a further slave of it
        std::string compatible, reg, interrupts;
        for (const std::string& name : d.compatible)
            compatible += fmt::format("{}\"{}\"", compatible.empty() ? "" : ", ", name);
        for (std::size_t m = n; m < devices.size() && devices[m].instance == d.instance; ++m)
            reg += fmt::format("{}<0x{:08x} 0x{:08x}>", reg.empty() ? "" : ", ",
                               devices[m].window + devices[m].base, devices[m].span);
        for (const unsigned number : d.interrupts)  // 4: while it is high
            interrupts +=
                fmt::format("{}<0 {} 4>", interrupts.empty() ? "" : ", ", number - FIRST_SPI);
        text += fmt::format(
            "{}: {}@{:08x} {{\n\tcompatible = {};\n\treg = {};\n{}}};\n", d.instance,
            d.group.empty() ? d.instance : d.group, d.window + d.base, compatible, reg,
            interrupts.empty()
                ? ""
                : fmt::format("\tinterrupt-parent = <&intc>;\n\tinterrupts = {};\n", interrupts));
    }
    return text;
}

}  // namespace sim::project::qsys
