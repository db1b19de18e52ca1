#include "sim/project/quartus/netlist.h"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <string>

#include <fmt/format.h>

#include "sim/project/quartus/netlist_reader.h"
#include "sim/project/settings.h"
#include "sim/project/syntax_tree.h"
#include "sim/project/tools.h"

namespace sim::project {

using Node = pugi::xml_node;

namespace {

constexpr unsigned long long MOST_BITS = 1u << 20;

// How many [a:b] has.
unsigned long long range_of(const Node& range) {
    const long long a = constant(range.first_child()),
                    b = constant(range.first_child().next_sibling());
    return static_cast<unsigned long long>(std::llabs(a - b) + 1);
}

}  // namespace

bool is_node(const Node& node, std::string_view name) { return node.name() == name; }

long long constant(const Node& node) {
    if (!is_node(node, "const")) return -1;
    const std::string value = node.attribute("name").value();
    const std::size_t quote = value.find('\'');
    if (quote == std::string::npos) return -1;
    std::size_t base = quote + 1;
    if (base < value.size() && value[base] == 's') ++base;
    if (base >= value.size() || value[base] != 'h' || value.size() - base > 16) return -1;
    char* end = nullptr;
    const long long number = std::strtoll(value.c_str() + base + 1, &end, 16);
    return *end == '\0' ? number : -1;
}

bool has_z(const Node& node) {
    if (is_node(node, "const")) {
        const std::string value = node.attribute("name").value();
        return value.find_first_of("zZ?", value.find('\'') + 1) != std::string::npos;
    }
    for (const Node& child : node.children())
        if (has_z(child)) return true;
    return false;
}

namespace {

using TypeNodes = std::map<std::string, Node>;

// The bits of a type, at most MOST_BITS, which stands for what is not known, too.
unsigned long long bits_of(const TypeNodes& nodes, const std::string& id, unsigned depth = 0) {
    const auto found = nodes.find(id);
    if (found == nodes.end() || depth > 32) return MOST_BITS;
    const Node& type = found->second;
    const std::string_view kind = type.name();
    const auto bits_below = [&](const Node& node) {
        return bits_of(nodes, node.attribute("sub_dtype_id").value(), depth + 1);
    };
    unsigned long long bits = MOST_BITS;
    if (kind == "basicdtype") {
        bits = static_cast<unsigned long long>(
            std::llabs(type.attribute("left").as_llong() - type.attribute("right").as_llong()) + 1);
    } else if (kind == "structdtype" || kind == "uniondtype") {
        bits = 0;
        for (const Node& member : type.children("memberdtype")) {
            const unsigned long long one = bits_below(member);
            bits = kind == "uniondtype" ? std::max(bits, one) : bits + one;
        }
    } else if (kind == "packarraydtype" || kind == "unpackarraydtype") {
        bits = bits_below(type) * range_of(type.child("range"));
    } else if (kind == "refdtype" || kind == "enumdtype" || kind == "constdtype") {
        bits = bits_below(type);
    }
    return std::min(bits, MOST_BITS);
}

}  // namespace

void Netlist::read_types(const Node& table) {
    TypeNodes nodes;
    for (const Node& type : table.children()) nodes.emplace(type.attribute("id").value(), type);
    for (const auto& [id, node] : nodes) {
        Type t;
        Node at = node;
        unsigned long long width = 1;
        for (unsigned depth = 0; depth < 20 && at; ++depth) {
            const std::string_view kind = at.name();
            const auto next = [&](const char* attribute) {
                const auto found = nodes.find(at.attribute(attribute).value());
                return found == nodes.end() ? Node{} : found->second;
            };
            if (kind == "basicdtype") {
                const std::string name = at.attribute("name").value();
                t.is_integer = name == "integer" || name == "int";
                if (const auto left = at.attribute("left")) {
                    if (depth == 0 || !t.is_vector) {
                        t.left = left.as_int();
                        t.right = at.attribute("right").as_int();
                    }
                    t.is_vector = true;
                    width *= static_cast<unsigned long long>(
                        std::llabs(left.as_llong() - at.attribute("right").as_llong()) + 1);
                }
                break;
            }
            if (kind == "unpackarraydtype") {
                t.is_array = true;
                t.words *= range_of(at.child("range"));
            } else if (kind == "packarraydtype") {
                width *= range_of(at.child("range"));
            } else if (kind != "refdtype" && kind != "enumdtype" && kind != "constdtype") {
                width *= bits_of(nodes, at.attribute("id").value());  // a structure
                break;
            }
            at = next("sub_dtype_id");
        }
        t.width = static_cast<unsigned>(std::min(width, MOST_BITS));
        types_[id] = t;
    }
}

Netlist::Netlist(const std::string& tree_file) : document_{syntax_tree(tree_file)} {
    const Node root = document_.child("verilator_xml"), netlist = root.child("netlist");
    for (const Node& file : root.child("files").children())
        files_.emplace(file.attribute("id").value(),
                       with_blanks(file.attribute("filename").value()));
    read_types(netlist.child("typetable"));
    for (const Node& node : netlist.children("module")) {
        NetModule& module = modules_[node.attribute("name").value()];
        module.name = node.attribute("origName").value();
        module.place = place(node);
        module.is_top = node.attribute("topModule").as_bool();
        const std::string& file = module.place.file;
        module.is_own = file.compare(0, 5, "data/") != 0 && file[0] != '<' &&
                        file.find(" in Verilog") == std::string::npos &&
                        file.compare(0, 7, "source/") != 0;
        module.node = node;
        read_module(*this, module, node);
    }
    for (auto& [key, module] : modules_) {
        for (Instance& i : module.instances)
            for (Connection& c : i.connections) name_port(c.port, i.of);
        for (Variable& v : module.variables)
            for (Driver& d : v.drivers) name_port(d.port, d.of);
    }
}

// Connections in the order of the ports have numbers in the place of names.
void Netlist::name_port(std::string& port, const std::string& module) const {
    const auto of = modules_.find(module);
    if (of == modules_.end()) return;
    const auto name = of->second.port_names.find(port);
    if (name != of->second.port_names.end()) port = name->second;
}

Place Netlist::place(const Node& node) const {
    const std::string loc = node.attribute("loc").value();
    const std::size_t comma = loc.find(',');
    if (comma == std::string::npos) return {};
    const auto file = files_.find(loc.substr(0, comma));
    return {file == files_.end() ? "" : file->second,
            static_cast<unsigned>(std::strtoul(loc.c_str() + comma + 1, nullptr, 10))};
}

unsigned Netlist::width(const Node& node) const {
    const auto type = types_.find(node.attribute("dtype_id").value());
    return type == types_.end() ? 1 : type->second.width;
}

bool Netlist::drives(const std::string& name, const std::string& port, unsigned depth) const {
    constexpr unsigned DEEPEST_HIERARCHY = 100;
    const auto module = modules_.find(name);
    if (module == modules_.end() || depth > DEEPEST_HIERARCHY) return false;
    const auto found = module->second.ports.find(port);
    if (found == module->second.ports.end()) return false;
    bool is_driven = false;
    for (const Driver& d : module->second.variables[found->second].drivers) {
        if (d.kind == Driver::Kind::INITIAL) continue;
        if (d.high_z) return false;
        if (d.kind == Driver::Kind::INSTANCE && !drives(d.of, d.port, depth + 1)) return false;
        is_driven = true;
    }
    return is_driven;
}

}  // namespace sim::project
