#include "sim/vhdl/vhdl_output.h"

#include <cctype>
#include <set>
#include <sstream>

#include <fmt/format.h>

#include "sim/text/lower.h"
#include "sim/verilog/project_error.h"
#include "sim/vhdl/ghdl_text.h"
#include "sim/vhdl/vhdl_enables.h"
#include "sim/vhdl/vhdl_inouts.h"

namespace sim::project {

namespace {

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

std::vector<std::string> lines_of(const std::string& text) {
    std::istringstream in{text};
    std::vector<std::string> lines;
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return lines;
}

// The module that `line` begins an instance of, "  NAME instance (" or "  NAME #("; else empty.
std::string instanced(const std::string& line) {
    const std::size_t name_end = line.find(' ', 2);
    if (line.compare(0, 2, "  ") != 0 || line[2] == ' ' || name_end == std::string::npos) return {};
    const std::string name = line.substr(2, name_end - 2), rest = line.substr(name_end + 1);
    const bool named = rest.size() > 2 && rest.find(' ') == rest.size() - 2 && rest[0] != '@' &&
                       rest.back() == '(';
    return rest == "#(" || named ? name : std::string{};
}

}  // namespace

VhdlOutput::VhdlOutput(const std::string& output, const std::string& root,
                       const std::string& module, const InVerilog& in_verilog) {
    const std::string text = "\n" + output, begin = "\nmodule ", end = "\nendmodule\n";
    for (std::size_t at = text.find(begin); at != std::string::npos; at = text.find(begin, at)) {
        const std::size_t after = text.find(end, at);
        if (after == std::string::npos) return;
        add(text.substr(at + 1, after + end.size() - at - 1), root, module);
        at = after;
    }
    // GHDL 5 writes no module for a component without an entity.
    for (const Module& of : modules_)
        for (const std::string& line : lines_of(of.text))
            if (const std::string name = instanced(line); !name.empty()) components_[name];
    for (const Module& of : modules_) components_.erase(of.name);
    for (auto& [name, found] : components_) {
        found = in_verilog(name);
        if (!found) throw ProjectError{fmt::format("component {}: no file defines it", name)};
    }
}

// GHDL 2 writes a module for a component without an entity, with nothing after its ports.
void VhdlOutput::add(std::string text, const std::string& root, const std::string& module) {
    std::string name = text.substr(7, text.find_first_of(" \n(", 7) - 7);
    if (lower(name) == lower(root)) {
        text.replace(7, name.size(), module);
        name = module;
    }
    const std::size_t ports = text.find(");\n");
    if (ports == std::string::npos || text.compare(ports + 3, 9, "endmodule") != 0) {
        modules_.push_back({name, std::move(text)});
        return;
    }
    components_[name];
}

// After the line of an instance comes one for each connection.
void VhdlOutput::rename(std::string& module) const {
    std::istringstream lines{module};
    module.clear();
    const ModuleText* of = nullptr;
    for (std::string line; std::getline(lines, line); module += line + "\n") {
        const std::size_t end = line.find_first_of(" (", 5);
        if (line.compare(0, 5, "    .") == 0) {
            if (of) line.replace(5, end - 5, name_in(*of, line.substr(5, end - 5)));
        } else if (line.compare(0, 4, "    ") != 0) {
            const std::string name = instanced(line);
            const auto found = components_.find(name);
            of = found == components_.end() ? nullptr : found->second;
            if (of) line.replace(2, name.size(), of->name);
        }
    }
}

std::string VhdlOutput::without(std::set<std::string>& known) const {
    Inouts inouts;
    for (const Module& module : modules_)
        inouts[module.name] = Declarations{lines_of(module.text)}.inouts;
    for (const auto& [component, module] : components_) inouts[module->name] = module->inouts;
    std::string text;
    for (const Module& module : modules_) {
        if (!known.insert(module.name).second) continue;
        std::string body = module.text;
        rename(body);
        std::vector<std::string> lines = lines_of(body);
        join_inouts(lines, inouts);
        text += with_enables(lines) + "\n";
    }
    return text;
}

}  // namespace sim::project
