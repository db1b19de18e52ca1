#include "sim/vhdl/vhdl_generics.h"

#include <algorithm>
#include <cctype>
#include <optional>
#include <set>
#include <sstream>

#include <fmt/format.h>

#include "sim/text/lower.h"
#include "sim/verilog/project_error.h"
#include "sim/verilog/tokens.h"

namespace sim::project {

namespace fs = std::filesystem;

namespace {

const char DEFAULT_VALUE[] = "\"de1sim: the default\"";  // no design has this value

// 32'sh1f as bits, from the highest on; nothing: it is a text, or has x.
std::optional<std::string> bits_of(const std::string& literal) {
    const std::size_t quote = literal.find('\''), base = literal.find('h');
    if (quote == std::string::npos || base == std::string::npos || literal[0] == '"') return {};
    std::string bits;
    for (const char digit : literal.substr(base + 1)) {
        if (!std::isxdigit(static_cast<unsigned char>(digit))) return {};
        const int value = std::stoi(std::string{digit}, nullptr, 16);
        for (int bit = 3; bit >= 0; --bit) bits += value >> bit & 1 ? '1' : '0';
    }
    const std::size_t width = std::stoul(literal);
    bits.insert(0, width - std::min(width, bits.size()), '0');
    return bits.substr(bits.size() - width);
}

std::optional<std::string> number_value(const std::string& literal) {
    auto bits = bits_of(literal);
    if (!bits || bits->size() > 64) return {};
    const bool negative = (literal.find("'s") != std::string::npos) && bits->front() == '1';
    bits->insert(0, 64 - bits->size(), negative ? '1' : '0');
    return std::to_string(static_cast<long long>(std::stoull(*bits, nullptr, 2)));
}

std::string text_value(const std::string& literal) {
    if (literal[0] == '"') return literal.substr(1, literal.size() - 2);
    const std::string bits = bits_of(literal).value_or("");
    std::string result;
    for (std::size_t at = bits.size() % 8; at + 8 <= bits.size(); at += 8)
        if (const int c = std::stoi(bits.substr(at, 8), nullptr, 2)) result += static_cast<char>(c);
    return result;
}

// As many bits as the type says: std_logic_vector ( 3 downto 0 ).
std::optional<std::string> vector_value(const std::string& literal,
                                        const std::vector<std::string>& type) {
    auto bits = bits_of(literal);
    const auto is_number = [](const std::string& word) {
        return std::all_of(word.begin(), word.end(),
                           [](char c) { return std::isdigit(static_cast<unsigned char>(c)); });
    };
    if (!bits || type.size() != 6 || !is_number(type[2]) || !is_number(type[4])) return bits;
    const long width = std::labs(std::stol(type[2]) - std::stol(type[4])) + 1;
    const std::size_t wanted = static_cast<std::size_t>(width);
    bits->insert(0, wanted - std::min(wanted, bits->size()), '0');
    return bits->substr(bits->size() - wanted);
}

std::optional<std::string> as_ghdl_takes_it(const std::string& literal,
                                            const std::vector<std::string>& type) {
    static const std::set<std::string> NUMBERS{"integer", "natural", "positive"};
    static const std::set<std::string> BITS{"std_logic", "std_ulogic", "bit"};
    static const std::set<std::string> VECTORS{"std_logic_vector", "std_ulogic_vector",
                                               "bit_vector", "unsigned", "signed"};
    const std::string& name = type.empty() ? literal : type[0];
    if (NUMBERS.count(name)) return number_value(literal);
    if (VECTORS.count(name)) return vector_value(literal, type);
    if (name == "string") return text_value(literal);
    const auto bits = bits_of(literal);
    if (!bits) return {};
    const bool one = bits->find('1') != std::string::npos;
    if (name == "boolean") return one ? "true" : "false";
    if (BITS.count(name)) return one ? "'1'" : "'0'";
    return {};
}

// A line of a module's ports: "  (input  [3:0] a," and its parts.
struct PortLine {
    std::string line, direction, name;
    unsigned left;
};
std::map<std::string, PortLine> ports_of(const std::string& module, const std::string& name) {
    std::map<std::string, PortLine> ports;
    const std::size_t at = module.find("module " + name + "\n");
    if (at == std::string::npos) return ports;
    std::istringstream lines{module.substr(at)};
    std::string line;
    std::getline(lines, line);
    while (std::getline(lines, line)) {
        line.erase(0, 3);
        PortLine port{line.substr(0, line.find_first_of(",)")), {}, {}, 0};
        std::istringstream words{port.line};
        words >> port.direction >> port.name;
        if (port.name[0] == '[') {
            port.left = static_cast<unsigned>(std::stoul(port.name.substr(1)));
            words >> port.name;
        }
        if (port.name[0] == '\\') port.name.erase(0, 1);
        ports[lower(port.name)] = port;
        if (line.find(");") != std::string::npos) break;
    }
    return ports;
}

// Escaped, where it is a keyword of Verilog.
std::string escaped(const std::string& name) {
    return is_keyword(name) ? fmt::format("\\{} ", name) : name;
}

std::string direction_of(const EntityHead::Member& port) {
    const std::string mode = port.type.empty() ? "in" : port.type[0];
    return mode == "out" || mode == "buffer" ? "output" : mode == "inout" ? "inout" : "input";
}

std::string in_upper_case(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(), ::toupper);
    return text;
}

}  // namespace

bool is_generic(const EntityHead& head, const std::string& name) {
    return std::any_of(head.generics.begin(), head.generics.end(),
                       [&](const auto& generic) { return lower(generic.name) == lower(name); });
}

std::string GenericEntity::module(std::size_t set) const {
    if (!is_set) return name;
    return fmt::format("{}_de1sim_{}", name, set);
}

std::vector<std::string> GenericEntity::options(std::size_t set) const {
    std::vector<std::string> words;
    for (const auto& generic : head.generics) {
        const auto value = sets[set].find(in_upper_case(generic.name));
        if (value == sets[set].end()) continue;
        const auto word = as_ghdl_takes_it(value->second, generic.type);
        if (!word)
            throw ProjectError{
                fmt::format("{}: entity {}: generic {} cannot have the value {} from Verilog, "
                            "expected a number, "
                            "boolean, std_logic, a vector of bits or a string, without x",
                            file, head.name, generic.name, value->second)};
        words.push_back(fmt::format("-g{}={}", generic.name, *word));
    }
    return words;
}

// The parameters are there in both cases, and the upper one counts.
std::string GenericEntity::wrapper(const std::vector<std::string>& modules) const {
    std::set<std::string> known;
    std::string first, others;
    for (const auto& generic : head.generics) {
        std::string before = lower(generic.name);
        first +=
            fmt::format("{}{} = {}", first.empty() ? "" : ", ", escaped(before), DEFAULT_VALUE);
        known.insert(before);
        for (const std::string& twin : {generic.name, in_upper_case(generic.name)})
            if (known.insert(twin).second) {
                others += fmt::format(", {} = {}", escaped(twin), escaped(before));
                before = twin;
            }
    }
    std::vector<std::string> conditions;
    for (const ParameterSet& set : sets) {
        std::string all;
        for (const auto& generic : head.generics) {
            const auto value = set.find(in_upper_case(generic.name));
            all += fmt::format("{}{} == {}", all.empty() ? "" : " && ", in_upper_case(generic.name),
                               value == set.end() ? DEFAULT_VALUE : value->second);
        }
        conditions.push_back("(" + all + ")");
    }
    std::vector<std::map<std::string, PortLine>> of_sets;
    for (std::size_t n = 0; n < modules.size(); ++n)
        of_sets.push_back(ports_of(modules[n], module(n)));
    std::string ports, connections;
    for (const auto& port : head.ports) {
        std::string range;
        for (std::size_t n = 0; n < of_sets.size(); ++n)
            range += fmt::format("{} ? {} : ", conditions[n], of_sets[n][lower(port.name)].left);
        const std::string name_of_port = escaped(port.name);
        ports += fmt::format("{}    {} [{}0:0] {}", ports.empty() ? "" : ",\n", direction_of(port),
                             range, name_of_port);
        connections +=
            fmt::format("{}.{}({})", connections.empty() ? "" : ", ", name_of_port, name_of_port);
    }
    std::string chosen;
    for (std::size_t n = 0; n < of_sets.size(); ++n)
        chosen += fmt::format("    {}if {} begin : de1sim_{}\n        {} u ({});\n    end\n",
                              n ? "else " : "", conditions[n], n, module(n), connections);
    return fmt::format(
        "module {} #(parameter {}{}) (\n{}\n);\n    generate\n{}    endgenerate\nendmodule\n", name,
        first, others, ports, chosen);
}

TopParameters GenericEntity::with_its_names(const TopParameters& parameters) const {
    TopParameters all;
    for (const auto& [set, parameter] : parameters)
        all[is_generic(head, set) ? in_upper_case(set) : set] = parameter;
    return all;
}

bool GenericEntity::add(const std::vector<ParameterSet>& found) {
    bool is_new = false;
    for (const ParameterSet& values : found) {
        ParameterSet set;
        for (const auto& generic : head.generics) {
            const auto value = values.find(in_upper_case(generic.name));
            if (value != values.end() && text_value(value->second) != text_value(DEFAULT_VALUE))
                set.emplace(value->first, value->second);
        }
        if (std::find(sets.begin(), sets.end(), set) != sets.end()) continue;
        sets.push_back(set);
        is_new = true;
    }
    return is_new;
}

std::string GenericEntity::in_order(const std::string& text) const {
    std::string all = text;
    for (std::size_t n = 0; n < sets.size(); ++n) {
        const std::size_t at = all.find("module " + module(n) + "\n"), end = all.find(");\n", at);
        const auto ports = ports_of(all, module(n));
        std::string list;
        for (const auto& port : head.ports) {
            const auto found = ports.find(lower(port.name));
            if (found == ports.end()) return text;
            list += fmt::format("{}{}", list.empty() ? "  (" : ",\n   ", found->second.line);
        }
        if (at == std::string::npos || ports.size() != head.ports.size()) return text;
        const std::size_t open = all.find('\n', at) + 1;
        all.replace(open, end - open, list);
    }
    return all;
}

}  // namespace sim::project
