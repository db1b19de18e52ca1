#include "sim/project/elaborated.h"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include <fmt/format.h>
#include <pugixml.hpp>

#include "sim/project/settings.h"
#include "sim/project/syntax_tree.h"
#include "sim/text/lower.h"

namespace sim::project {

namespace {

constexpr long long MOST_BITS = 1024;  // in a port; the chip has 457 pins for all

// The value of a constant as Verilator prints it: 64'h1f, 32'sh2.
std::uint64_t value_of(const pugi::xml_node& parameter) {
    const std::string text = parameter.child("const").attribute("name").value();
    const std::size_t digits = text.find_last_of('h');
    return digits == std::string::npos ? 0
                                       : std::stoull("0" + text.substr(digits + 1), nullptr, 16);
}

// The text of a constant, as Verilator prints it: 64'h666f6e742e6d6966, or "font.mif".
std::string text_of_value(const pugi::xml_node& parameter) {
    const std::string value = parameter.child("const").attribute("name").value();
    if (value.size() > 1 && value[0] == '"') return value.substr(1, value.size() - 2);
    const std::size_t digits = value.find_last_of('h');
    if (digits == std::string::npos) return {};
    std::string hex = value.substr(digits + 1), text;
    if (hex.size() % 2) hex.insert(0, "0");
    for (std::size_t i = 0; i < hex.size(); i += 2)
        if (const int c = std::stoi(hex.substr(i, 2), nullptr, 16)) text += static_cast<char>(c);
    return text;
}

// Files by the letters that stand for them in places.
std::map<std::string, std::string> paths_of(const pugi::xml_node& root) {
    std::map<std::string, std::string> paths;
    for (const auto& file : root.child("files").children())
        paths.emplace(file.attribute("id").value(), file.attribute("filename").value());
    return paths;
}

// "top.v:3"
std::string place_of(const pugi::xml_node& node, const std::map<std::string, std::string>& paths) {
    const std::string place = node.attribute("loc").value();
    const std::size_t comma = place.find(',');
    return fmt::format("{}:{}", paths.at(place.substr(0, comma)),
                       std::stoi(place.substr(comma + 1)));
}

// Of the instances in files of the design: what the models instance themselves has the same file.
std::vector<InitFile> init_files_of(const pugi::xml_node& root) {
    const std::map<std::string, std::string> paths = paths_of(root);
    std::map<std::string, std::string> files;  // by the module
    const auto modules = root.child("netlist").children("module");
    for (const auto& module : modules) {
        if (place_of(module, paths).compare(0, 5, "data/") != 0) continue;  // is no model
        for (const auto& var : module.children("var")) {
            const std::string name = var.attribute("name").value();
            if (var.attribute("param") && (name == "INIT_FILE" || name == "LPM_FILE"))
                files[module.attribute("name").value()] = text_of_value(var);
            else if (var.attribute("param") && name == "init_file")  // Platform Designer's
                files.emplace(module.attribute("name").value(), text_of_value(var));
        }
    }
    std::vector<InitFile> wanted;
    for (const auto& module : modules)
        for (const auto& found : module.select_nodes(".//instance")) {
            const auto file = files.find(found.node().attribute("defName").value());
            const std::string place = place_of(found.node(), paths);
            if (file == files.end() || place.compare(0, 5, "data/") == 0) continue;
            std::string name = file->second;
            if (!name.empty() && name.back() == '?') name.pop_back();  // it may be nowhere
            if (!name.empty() && lower(name) != "unused" && lower(name) != "none")
                wanted.push_back({name, place, {}});
        }
    return wanted;
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
        const long long bits = std::llabs(left.as_llong() - port.right) + 1;
        if (bits > MOST_BITS)
            throw ProjectError{
                fmt::format("port {} of the top module has {} bits, expected at most {}", port.name,
                            bits, MOST_BITS)};
    }
    return port;
}

// C++ in Verilog, and commands of this machine: Verilator takes them, and no board has them.
void refuse_foreign_code(const pugi::xml_document& document) {
    static const std::map<std::string, const char*> KINDS{{"systemt", "$system"},
                                                          {"systemf", "$system"},
                                                          {"ucstmt", "$c"},
                                                          {"ucfunc", "$c"},
                                                          {"cstmtuser", "$c"},
                                                          {"cexpruser", "$c"},
                                                          {"systemcsection", "`systemc_..."},
                                                          {"schdr", "`systemc_..."},
                                                          {"scimp", "`systemc_..."},
                                                          {"scctor", "`systemc_..."},
                                                          {"scdtor", "`systemc_..."},
                                                          {"scint", "`systemc_..."},
                                                          {"scimphdr", "`systemc_..."}};
    for (const auto& [element, word] : KINDS)
        if (const auto found = document.select_node(("//" + element).c_str()))
            throw ProjectError{fmt::format(
                "{}: {} runs code of this machine, which no board has; take it out",
                place_of(found.node(), paths_of(document.child("verilator_xml"))), word)};
}

// The copies of de1sim_pll_tap that make a clock, and what has them: all but those of the
// processor's user clocks that nobody connects.
std::map<std::string, std::set<std::string>> used_taps(const pugi::xml_node& netlist) {
    std::set<std::pair<std::string, std::string>> connected;  // a module's port
    for (const auto& module : netlist.children("module"))
        for (const auto& instance : module.select_nodes(".//instance"))  // also of a `generate`
            for (const auto& port : instance.node().children("port"))
                if (port.first_child())
                    connected.emplace(instance.node().attribute("defName").value(),
                                      port.attribute("name").value());
    std::map<std::string, std::set<std::string>> used;
    for (const auto& module : netlist.children("module")) {
        const bool is_processors = std::string{"cyclonev_hps_interface_clocks_resets"} ==
                                   module.attribute("origName").value();
        for (const auto& found : module.select_nodes(".//instance")) {
            const auto instance = found.node();
            const std::string clock =
                instance.child("port").child("varref").attribute("name").value();
            if (!is_processors || connected.count({module.attribute("name").value(), clock}))
                used[instance.attribute("defName").value()].insert(is_processors ? clock : "PLL");
        }
    }
    return used;
}

// Of two clocks that have become one: each pin may be held low by another reset.
std::optional<ClockUses::Use> use_of_both(const std::optional<ClockUses::Use>& a,
                                          const std::optional<ClockUses::Use>& b) {
    if (!a || !b || !a->pins.empty() || !b->pins.empty()) return {};
    return ClockUses::Use{a->rises || b->rises, a->locks || b->locks};
}

}  // namespace

Elaborated read_elaborated(const std::filesystem::path& file, const std::string& top) {
    const pugi::xml_document document = syntax_tree(file);
    refuse_foreign_code(document);
    const auto netlist = document.child("verilator_xml").child("netlist");
    std::map<std::string, pugi::xml_node> types;
    for (const auto& type : netlist.child("typetable").children())
        types.emplace(type.attribute("id").value(), type);

    Elaborated design;
    const auto taps = used_taps(netlist);
    const ClockUses uses{netlist};
    for (const auto& module : netlist.children("module")) {
        if (top == module.attribute("origName").value()) {
            std::map<int, Port> ports;
            for (const auto& var : module.children("var"))
                if (const auto index = var.attribute("pinIndex")) {
                    const Port port = port_of(var, types);
                    ports.emplace(index.as_int(), port);
                    if (port.direction != Direction::INPUT || port.vector) continue;
                    if (const auto use = uses.of_input(var))
                        design.input_uses.emplace(port.name, *use);
                }
            for (const auto& [index, port] : ports) design.ports.push_back(port);
        }
        const auto tap = taps.find(module.attribute("name").value());
        if (std::string{"de1sim_pll_tap"} == module.attribute("origName").value() &&
            tap != taps.end()) {
            std::map<std::string, std::uint64_t> values;
            for (const auto& var : module.children("var"))
                if (var.attribute("param"))
                    values[var.attribute("origName").value()] = value_of(var);
            const PllClock clock{
                values["PERIOD_FS"], values["PHASE_FS"],
                values["HIGH_FS"],   values["SETTABLE"] != 0,
                tap->second,         uses.of_tap(module.attribute("name").value())};
            auto& all = design.pll_clocks;
            const auto same = std::find(all.begin(), all.end(), clock);
            if (same != all.end()) {
                same->names.insert(clock.names.begin(), clock.names.end());
                same->use = use_of_both(same->use, clock.use);
            } else if (clock.period_fs) {
                all.push_back(clock);
            }
        }
    }
    design.init_files = init_files_of(document.child("verilator_xml"));
    return design;
}

std::vector<std::map<std::string, std::string>> parameters_of(const std::filesystem::path& file,
                                                              const std::string& module) {
    const pugi::xml_document document = syntax_tree(file);
    std::vector<std::map<std::string, std::string>> all;
    for (const auto& copy : document.child("verilator_xml").child("netlist").children("module")) {
        if (module != copy.attribute("origName").value()) continue;
        std::map<std::string, std::string> values;
        for (const auto& var : copy.children("var"))
            if (var.attribute("param"))
                values[var.attribute("origName").value()] =
                    var.child("const").attribute("name").value();
        all.push_back(std::move(values));
    }
    return all;
}

}  // namespace sim::project
