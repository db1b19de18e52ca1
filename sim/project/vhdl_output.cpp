#include "sim/project/vhdl_output.h"

#include <cctype>
#include <set>
#include <sstream>

#include <fmt/format.h>

#include "sim/project/file_finder.h"
#include "sim/project/settings.h"

namespace sim::project {

namespace {

// Verilator sees an enable only in the expression that drives a pin, where GHDL has a chain of
// wires: those that have a z are put in the place of their names.
std::string with_enables(const std::string& module) {
    std::istringstream lines{module};
    std::vector<std::string> text;
    for (std::string line; std::getline(lines, line);) text.push_back(line);
    const auto is_name = [](char c) {
        return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
    };
    const std::string assign = "  assign ";
    std::set<std::string> wires;
    for (const std::string& line : text)
        if (line.compare(0, 7, "  wire ") == 0)
            wires.insert(line.substr(line.rfind(' ') + 1, line.size() - line.rfind(' ') - 2));
    for (std::size_t from = 0; from < text.size(); ++from) {
        const std::string line = text[from];
        const std::size_t equals = line.find(" = "), end = line.find(';');
        if (line.compare(0, assign.size(), assign) != 0 || end == std::string::npos ||
            line.find("'bZ") > end)
            continue;
        const std::string name = line.substr(assign.size(), equals - assign.size());
        if (wires.count(name) == 0) continue;  // a port
        const std::string value = "(" + line.substr(equals + 3, end - equals - 3) + ")";
        bool used = false;
        for (std::string& other : text) {
            if (other.compare(0, assign.size(), assign) != 0) continue;
            for (std::size_t at = other.find(" = "); (at = other.find(name, at)) < other.find(';');
                 at += value.size()) {
                const std::size_t behind = at + name.size();
                if (is_name(other[at - 1]) || is_name(other[behind])) break;
                other.replace(at, name.size(), value);
                used = true;
            }
        }
        if (!used) continue;
        text[from].clear();
        from = static_cast<std::size_t>(-1);  // what uses it may itself be used before
    }
    std::string joined;
    for (const std::string& line : text) joined += line + "\n";
    return joined;
}

// The port or parameter of `module` that a component has as `name`, in any case; VHDL has `in` as
// `a_in`, since that is a word of its own.
std::string name_in(const ModuleText& module, const std::string& name) {
    std::string other;
    for (const auto* names : {&module.ports, &module.parameters})
        for (const std::string& known : *names) {
            if (known == name) return name;
            if (lower(known) == lower(name) || "a_" + known == lower(name)) other = known;
        }
    return other.empty() ? name : other;
}

}  // namespace

VhdlOutput::VhdlOutput(const std::string& said, const std::string& root,
                       const InVerilog& in_verilog) {
    const std::string text = "\n" + said, begin = "\nmodule ", end = "\nendmodule\n";
    for (std::size_t at = text.find(begin); at != std::string::npos; at = text.find(begin, at)) {
        const std::size_t behind = text.find(end, at);
        if (behind == std::string::npos) return;
        take(text.substr(at + 1, behind + end.size() - at - 1), root, in_verilog);
        at = behind;
    }
}

// A component without an entity has nothing between its ports and its end.
void VhdlOutput::take(std::string module, const std::string& root, const InVerilog& in_verilog) {
    std::string name = module.substr(7, module.find_first_of(" \n(", 7) - 7);
    if (lower(name) == lower(root)) {
        module.replace(7, name.size(), root);
        name = root;
    }
    const std::size_t ports = module.find(");\n");
    if (ports == std::string::npos || module.compare(ports + 3, 9, "endmodule") != 0) {
        modules_.push_back({name, std::move(module)});
        return;
    }
    components_[name] = in_verilog(name);
    if (!components_[name])
        throw ProjectError{fmt::format("component {}: no file defines it", name)};
}

// Instances of components are "  NAME instance (" or "  NAME #(", with a line for each connection.
void VhdlOutput::rename(std::string& module) const {
    std::istringstream lines{module};
    module.clear();
    const ModuleText* of = nullptr;
    for (std::string line; std::getline(lines, line); module += line + "\n") {
        const std::size_t end = line.find_first_of(" (", 5);
        if (line.compare(0, 5, "    .") == 0) {
            if (of) line.replace(5, end - 5, name_in(*of, line.substr(5, end - 5)));
        } else if (line.compare(0, 4, "    ") != 0) {
            const std::string name = line.substr(0, line.find(' ', 2)).erase(0, 2);
            const auto found = components_.find(name);
            of = found == components_.end() ? nullptr : found->second;
            if (of) line.replace(2, name.size(), of->name);
        }
    }
}

std::string VhdlOutput::without(std::set<std::string>& known) const {
    std::string text;
    for (const Module& module : modules_) {
        if (!known.insert(module.name).second) continue;
        std::string body = module.text;
        rename(body);
        text += with_enables(body) + "\n";
    }
    return text;
}

}  // namespace sim::project
