#include "sim/project/binding.h"

#include <algorithm>
#include <set>

#include <fmt/format.h>

namespace sim::project {

namespace {

std::string wire_of(const BoardSignal& signal, int index) {
    return signal.scalar ? std::string{signal.name} : fmt::format("{}[{}]", signal.name, index);
}

// The wire for bit `index` of a port that is `width` wide, by its name alone.
std::string by_name(const Port& port, int index, int width) {
    const auto signal = board_signal(port.name);
    if (!signal) return {};
    int bit = index - std::min(port.left, port.right);
    const bool colour =
        signal->name == "VGA_R" || signal->name == "VGA_G" || signal->name == "VGA_B";
    if (colour) bit += static_cast<int>(signal->width) - width;
    return bit >= 0 && bit < static_cast<int>(signal->width) ? wire_of(*signal, bit) : "";
}

const BoardSignal* signal_of_wire(const std::string& wire) {
    const std::string name = wire.substr(0, wire.find('['));
    for (const BoardSignal& signal : board_signals())
        if (signal.name == name) return &signal;
    return nullptr;
}

std::string wire_at(const Port& port, int index, int width,
                    const std::map<std::string, std::string>& locations,
                    const std::map<std::string, std::string>& signals_by_pin) {
    const auto location =
        locations.find(port.vector ? fmt::format("{}[{}]", port.name, index) : port.name);
    if (location != locations.end())
        if (const auto signal = signals_by_pin.find(location->second);
            signal != signals_by_pin.end() && signal_of_wire(signal->second))
            return signal->second;
    return by_name(port, index, width);
}

// What an output is where nothing drives it: lamps dark, chips not selected.
bool idle_level(const std::string& wire) {
    const std::string name = wire.substr(0, wire.find('['));
    return name.compare(0, 3, "HEX") == 0 || name == "VGA_HS" || name == "VGA_VS" ||
           (name.size() > 2 && name.compare(name.size() - 2, 2, "_N") == 0 && name != "VGA_SYNC_N");
}

bool is_low_active(const std::string& port) {
    const std::string name = port.size() > 2 ? port.substr(port.size() - 2) : "";
    return name == "_n" || name == "_N";
}

}  // namespace

Binding bind(const std::vector<Port>& ports, const std::map<std::string, std::string>& locations,
             const std::map<std::string, std::string>& signals_by_pin) {
    Binding binding;
    std::set<std::string> driven;
    std::string nowhere;
    for (const Port& port : ports) {
        const int step = port.left >= port.right ? -1 : 1;
        const int width = std::abs(port.left - port.right) + 1;
        Binding::BoundPort bound{port, {}};
        bool any = false;
        for (int index = port.left;; index += step) {
            std::string wire = wire_at(port, index, width, locations, signals_by_pin);
            const BoardSignal* signal = wire.empty() ? nullptr : signal_of_wire(wire);
            if (signal && port.direction == Direction::OUTPUT) {
                if (signal->direction == Direction::INPUT) {
                    binding.notes.push_back(fmt::format(
                        "output {} is on {}, which the board drives: left open", port.name, wire));
                    wire.clear();
                } else if (!driven.insert(wire).second) {
                    binding.notes.push_back(
                        fmt::format("output {} is on {}, which another output drives: left open",
                                    port.name, wire));
                    wire.clear();
                }
            } else if (signal && port.direction == Direction::INOUT) {
                driven.insert(wire);
            }
            any = any || !wire.empty();
            if (wire == "VGA_CLK" && port.direction != Direction::INPUT) binding.has_vga_clk = true;
            if (wire == "VGA_HS") binding.has_vga_hs = true;
            if (wire == "TD_CLK27") binding.has_td_clk = true;
            if (port.direction == Direction::OUTPUT && wire.compare(0, 5, "GPIO_") == 0)
                binding.header_outputs[wire[5] - '0'] |= std::uint64_t{1}
                                                         << std::stoi(wire.substr(7));
            bound.bits.push_back({std::move(wire)});
            if (index == port.right) break;
        }
        if (!any && port.name.compare(0, 4, "HPS_") != 0)
            nowhere += fmt::format("{}{}{}", nowhere.empty() ? "" : ", ", port.name,
                                   port.direction == Direction::INPUT
                                       ? is_low_active(port.name) ? " (is 1)" : " (is 0)"
                                       : "");
        binding.ports.push_back(std::move(bound));
    }
    if (!nowhere.empty()) binding.notes.push_back("ports without a pin of the board: " + nowhere);
    return binding;
}

std::string design_text(const Binding& binding, const std::string& top) {
    std::string wires, ports, assigns;
    std::set<std::string> driven;
    unsigned number = 0;
    for (const auto& [port, bits] : binding.ports) {
        const std::string own = fmt::format("de1sim_port_{}", number++);
        std::string value;
        bool needs_own = port.direction == Direction::OUTPUT;
        for (std::size_t i = 0; i < bits.size(); ++i) {
            const std::string& wire = bits[i].wire;
            const std::size_t position = bits.size() - 1 - i;
            if (port.direction == Direction::OUTPUT) {
                if (wire.empty()) continue;
                assigns += fmt::format("    assign {} = {}[{}];\n", wire, own, position);
                driven.insert(wire);
                continue;
            }
            value += value.empty() ? "" : ", ";
            if (!wire.empty()) {
                value += wire;
                if (port.direction == Direction::INOUT) driven.insert(wire);
            } else if (port.direction == Direction::INPUT) {
                value += is_low_active(port.name) ? "1'b1" : "1'b0";
            } else {
                value += fmt::format("{}[{}]", own, position);
                needs_own = true;
            }
        }
        if (needs_own) wires += fmt::format("    wire [{}:0] {};\n", bits.size() - 1, own);
        ports += fmt::format("{}        .{} ({})", ports.empty() ? "" : ",\n", port.name,
                             port.direction == Direction::OUTPUT ? own
                             : bits.size() > 1                   ? "{" + value + "}"
                                                                 : value);
    }
    for (const BoardSignal& signal : board_signals()) {
        if (signal.direction != Direction::OUTPUT) continue;
        for (unsigned i = 0; i < signal.width; ++i) {
            const std::string wire = wire_of(signal, static_cast<int>(i));
            if (!driven.count(wire))
                assigns += fmt::format("    assign {} = 1'b{:d};\n", wire, idle_level(wire));
        }
    }
    return fmt::format(
        "// Written by de1sim for the top module {}.\n{}    {} de1sim_design (\n{}\n    );\n{}",
        top, wires, top, ports, assigns);
}

}  // namespace sim::project
