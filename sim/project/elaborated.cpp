#include "sim/project/elaborated.h"

#include <algorithm>
#include <map>

#include <fmt/format.h>
#include <pugixml.hpp>

#include "sim/project/settings.h"

namespace sim::project {

namespace {

// The value of a constant as Verilator prints it: 64'h1f, 32'sh2.
std::uint64_t value_of(const pugi::xml_node& parameter) {
    const std::string text = parameter.child("const").attribute("name").value();
    const std::size_t digits = text.find_last_of('h');
    return digits == std::string::npos ? 0
                                       : std::stoull("0" + text.substr(digits + 1), nullptr, 16);
}

Port port_of(const pugi::xml_node& var, const std::map<std::string, pugi::xml_node>& types) {
    Port port{var.attribute("origName").value(), Direction::INPUT, 0, 0, false};
    const std::string direction = var.attribute("dir").value();
    if (direction == "output") port.direction = Direction::OUTPUT;
    if (direction == "inout") port.direction = Direction::INOUT;
    auto type = types.find(var.attribute("dtype_id").value());
    while (type != types.end() && std::string{type->second.name()} == "refdtype")
        type = types.find(type->second.attribute("sub_dtype_id").value());
    if (type == types.end() || std::string{type->second.name()} != "basicdtype")
        throw ProjectError{fmt::format(
            "port {} of the top module has a type that a pin cannot have, expected bits",
            port.name)};
    if (const auto left = type->second.attribute("left")) {
        port.vector = true;
        port.left = left.as_int();
        port.right = type->second.attribute("right").as_int();
    }
    return port;
}

}  // namespace

Elaborated read_elaborated(const std::filesystem::path& xml, const std::string& top) {
    pugi::xml_document document;
    const auto result = document.load_file(xml.c_str());
    if (!result) throw ProjectError{fmt::format("{}: {}", xml.string(), result.description())};
    const auto netlist = document.child("verilator_xml").child("netlist");
    std::map<std::string, pugi::xml_node> types;
    for (const auto& type : netlist.child("typetable").children())
        types.emplace(type.attribute("id").value(), type);

    Elaborated design;
    for (const auto& module : netlist.children("module")) {
        if (top == module.attribute("origName").value()) {
            std::map<int, Port> ports;
            for (const auto& var : module.children("var"))
                if (const auto index = var.attribute("pinIndex"))
                    ports.emplace(index.as_int(), port_of(var, types));
            for (const auto& [index, port] : ports) design.ports.push_back(port);
        }
        if (std::string{"de1sim_pll_tap"} == module.attribute("origName").value()) {
            std::map<std::string, std::uint64_t> values;
            for (const auto& var : module.children("var"))
                if (var.attribute("param"))
                    values[var.attribute("origName").value()] = value_of(var);
            const PllClock clock{values["PERIOD_FS"], values["PHASE_FS"], values["HIGH_FS"]};
            const auto& all = design.pll_clocks;
            if (clock.period_fs && std::find(all.begin(), all.end(), clock) == all.end())
                design.pll_clocks.push_back(clock);
        }
    }
    return design;
}

}  // namespace sim::project
