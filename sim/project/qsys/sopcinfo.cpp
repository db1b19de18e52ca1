#include "sim/project/qsys/sopcinfo.h"

#include <algorithm>
#include <string_view>

#include <fmt/format.h>
#include <pugixml.hpp>

#include "sim/hps/bridge_windows.h"
#include "sim/project/qsys/verilog_text.h"
#include "sim/project/settings.h"
#include "sim/text/printable.h"

namespace sim::project::qsys {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void fail(const fs::path& file, const std::string& what) {
    throw ProjectError{printable(file.filename().string() + ": " + what)};
}

std::string name_in(const pugi::xml_node& node, const fs::path& file) {
    const std::string name = node.child_value("name");
    if (!is_name(name))
        fail(file, fmt::format("the name `{}`, expected letters, digits and _", name));
    return name;
}

Port port_in(const pugi::xml_node& node, const fs::path& file) {
    const std::string_view direction = node.child_value("direction");
    const std::string name = name_in(node, file);
    const unsigned width = node.child("width").text().as_uint();
    if (width > WIDEST_PORT)
        fail(file,
             fmt::format("port {} is {} bits wide, expected 1 to {}", name, width, WIDEST_PORT));
    return {name, node.child_value("role"),
            direction == "Output"  ? Port::Direction::OUTPUT
            : direction == "Bidir" ? Port::Direction::BIDIR
                                   : Port::Direction::INPUT,
            width, width != 1};
}

pugi::xml_document document_of(const fs::path& file) {
    pugi::xml_document document;
    const std::string text = text_of(file);
    if (const pugi::xml_parse_result result = document.load_string(text.c_str()); !result)
        fail(file, std::string{"this is broken XML: "} + result.description());
    return document;
}

}  // namespace

std::optional<Component> component_in_sopcinfo(const fs::path& file, const Instance& instance) {
    const pugi::xml_document document = document_of(file);
    for (const pugi::xml_node& module : document.document_element().children("module")) {
        if (module.attribute("name").value() != instance.name ||
            module.attribute("kind").value() != instance.kind)
            continue;
        Component component;
        component.file = file;
        component.kind = instance.kind;
        component.version = module.attribute("version").value();
        for (const pugi::xml_node& a : module.children("assignment"))
            component.assignments[a.child_value("name")] = a.child_value("value");
        for (const pugi::xml_node& node : module.children("interface")) {
            Interface i{node.attribute("name").value(),
                        node.child_value("type"),
                        std::string_view{node.child_value("isStart")} == "true",
                        {},
                        {}};
            for (const pugi::xml_node& p : node.children("parameter"))
                i.properties[p.attribute("name").value()] = p.child_value("value");
            for (const pugi::xml_node& p : node.children("port"))
                i.ports.push_back(port_in(p, file));
            if (!is_name(i.name)) fail(file, fmt::format("an interface has the name `{}`", i.name));
            component.interfaces.push_back(std::move(i));
        }
        return component;
    }
    return {};
}

std::vector<Place> map_in_sopcinfo(const fs::path& file) {
    const pugi::xml_document document = document_of(file);
    std::vector<Place> map;
    for (const pugi::xml_node& module : document.document_element().children("module")) {
        if (std::string_view{module.attribute("kind").value()} != "altera_hps") continue;
        const std::string processor = module.attribute("name").value();
        for (const pugi::xml_node& master : module.children("interface"))
            for (const pugi::xml_node& block : master.children("memoryBlock")) {
                const std::string bridge = master.attribute("name").value();
                if (bridge != "h2f_lw_axi_master" && bridge != "h2f_axi_master") continue;
                map.push_back({processor + "." + bridge,
                               block.child_value("moduleName") + std::string{"."} +
                                   block.child_value("slaveName"),
                               block.child("baseAddress").text().as_ullong(),
                               block.child("span").text().as_ullong(), true, true,
                               bridge == "h2f_axi_master" ? H2F_BASE : LW_BASE});
            }
    }
    return map;
}

}  // namespace sim::project::qsys
