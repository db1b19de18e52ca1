#include "sim/vhdl/vhdl_inouts.h"

#include <cctype>
#include <optional>

#include <fmt/format.h>

#include "sim/vhdl/ghdl_text.h"

namespace sim::project {

namespace {

class Joiner {
public:
    explicit Joiner(std::vector<std::string>& lines) : lines_{lines}, declared_{lines} {}

    // Instances' wires that are part of what drives an inout port, from its lowest bit on.
    void run(const Inouts& inouts) {
        std::set<std::string> wires;  // at inout ports of instances
        const std::set<std::string>* of = nullptr;
        for (const std::string& line : lines_) {
            if (line.rfind("    .", 0) == 0) {
                const std::size_t open = line.find('(');
                if (of && of->count(line.substr(5, open - 5)))
                    wires.insert(line.substr(open + 1, line.find(')') - open - 1));
            } else if (line.rfind("    ", 0) != 0) {
                const auto found = inouts.find(trimmed(line.substr(0, line.find(' ', 2))));
                of = found == inouts.end() ? nullptr : &found->second;
            }
        }
        std::map<std::string, std::string> values;  // of what is assigned once
        for (const std::string& line : lines_)
            if (const auto a = assignment_in(line); a && line.rfind("  assign ", 0) == 0)
                values.emplace(a->target, a->value);
        for (const std::string& port : declared_.inouts) join(port, port, 0, values, wires);
    }

private:
    void join(const std::string& port, const std::string& name, std::size_t low,
              const std::map<std::string, std::string>& values,
              const std::set<std::string>& wires) {
        const auto found = values.find(name);
        const auto p = found == values.end() ? std::nullopt : passed(found->second);
        if (!p || !p->condition.empty()) return;
        for (auto atom = p->atoms.rbegin(); atom != p->atoms.rend();
             low += declared_.width_of(*atom++)) {
            if (declared_.width_of(*atom) == 0) return;
            if (!wires.count(*atom)) {
                join(port, *atom, low, values, wires);
                continue;
            }
            const std::size_t width = declared_.width_of(*atom);
            const std::string bits = width == declared_.widths.at(port) ? port
                                     : width == 1
                                         ? fmt::format("{}[{}]", port, low)
                                         : fmt::format("{}[{}:{}]", port, low + width - 1, low);
            replace_wire(*atom, name, bits, fmt::format("{}'bZ", width));
        }
    }
    // In what drives `name` it is released, and elsewhere the port's bits.
    void replace_wire(const std::string& wire, const std::string& name, const std::string& bits,
                      const std::string& released) {
        for (std::string& line : lines_) {
            if (line.rfind("  wire ", 0) == 0) continue;
            const auto a = assignment_in(line);
            const std::string& to = a && a->target == name ? released : bits;
            const auto in_name = [](char c) {
                return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
            };
            for (std::size_t at = 0; (at = line.find(wire, at)) != std::string::npos;) {
                const std::size_t after = at + wire.size();
                const bool whole = !in_name(line[at - 1]) && line[at - 1] != '.' &&
                                   (after >= line.size() || !in_name(line[after]));
                if (whole) line.replace(at, wire.size(), to);
                at += whole ? to.size() : wire.size();
            }
        }
    }

    std::vector<std::string>& lines_;
    const Declarations declared_;
};

}  // namespace

void join_inouts(std::vector<std::string>& lines, const Inouts& inouts) {
    Joiner{lines}.run(inouts);
}

}  // namespace sim::project
