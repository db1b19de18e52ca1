#include "sim/project/binding.h"

#include <algorithm>
#include <set>

#include <fmt/format.h>

namespace sim::project {

namespace {

std::string wire_of(const BoardSignal& signal, int index) {
    return signal.scalar ? std::string{signal.name} : fmt::format("{}[{}]", signal.name, index);
}

using Locations = std::map<std::string, std::string>;

// The wire for bit `bit` of a port, counted from the right, by its name alone.
std::string by_name(const Port& port, int bit) {
    const auto signal = board_signal(port.name);
    return signal && bit >= 0 && bit < static_cast<int>(signal->width) ? wire_of(*signal, bit) : "";
}

// What to add to a bit of a colour so that the uppermost of `width` is the board's uppermost.
int colour_shift(const Port& port, int width) {
    const auto signal = board_signal(port.name);
    if (!signal) return 0;
    const bool colour =
        signal->name == "VGA_R" || signal->name == "VGA_G" || signal->name == "VGA_B";
    return colour ? static_cast<int>(signal->width) - width : 0;
}

const BoardSignal* signal_of_wire(const std::string& wire) {
    const std::string name = wire.substr(0, wire.find('['));
    for (const BoardSignal& signal : board_signals())
        if (signal.name == name) return &signal;
    return nullptr;
}

// The wire that a location gives to bit `index`, or empty.
std::string by_location(const Port& port, int index, const Locations& locations,
                        const Locations& signals_by_pin) {
    const auto location =
        locations.find(port.vector ? fmt::format("{}[{}]", port.name, index) : port.name);
    if (location == locations.end()) return {};
    const auto signal = signals_by_pin.find(location->second);
    return signal != signals_by_pin.end() && signal_of_wire(signal->second) ? signal->second : "";
}

// A port's bits, from the left, as far as locations tell.
std::vector<std::string> located_wires(const Port& port, const Locations& locations,
                                       const Locations& signals_by_pin) {
    std::vector<std::string> wires;
    for (int index = port.left;; index += port.left >= port.right ? -1 : 1) {
        wires.push_back(by_location(port, index, locations, signals_by_pin));
        if (index == port.right) return wires;
    }
}

// Fills in the other bits by the port's name.  A pin that a location gives to another output stays
// that one's.
void name_wires(std::vector<std::string>& wires, const Port& port,
                const std::set<std::string>& located, std::vector<std::string>& notes) {
    const bool all =
        std::all_of(wires.begin(), wires.end(), [](auto& wire) { return wire.empty(); });
    const int width = static_cast<int>(wires.size());
    for (int i = 0; i < width; ++i) {
        std::string& wire = wires[static_cast<std::size_t>(i)];
        if (!wire.empty()) continue;
        const int bit = port.left >= port.right ? width - 1 - i : i;
        wire = by_name(port, bit + (all ? colour_shift(port, width) : 0));
        if (port.direction == Direction::INPUT || !located.count(wire)) continue;
        notes.push_back(fmt::format("output {} is on {}, which another output drives: left open",
                                    port.name, wire));
        wire.clear();
    }
}

bool is_header(const std::string& wire) { return wire.compare(0, 5, "GPIO_") == 0; }

// What an output is where nothing drives it: lamps dark, chips not selected.  (Quartus pulls pins
// that are not used up, which counts for DRAM_CKE alone.)
bool idle_level(const std::string& wire) {
    const std::string name = wire.substr(0, wire.find('['));
    return name.compare(0, 3, "HEX") == 0 || name == "VGA_HS" || name == "VGA_VS" ||
           name == "DRAM_CKE" ||
           (name.size() > 2 && name.compare(name.size() - 2, 2, "_N") == 0 && name != "VGA_SYNC_N");
}

bool is_low_active(const std::string& port) {
    const std::string name = port.size() > 2 ? port.substr(port.size() - 2) : "";
    return name == "_n" || name == "_N";
}

// Verilator takes a header for driven as a whole as soon as one of its pins is driven always.
std::string driver_text(const std::string& wire, const std::string& value) {
    return is_header(wire) ? "$c1(\"1\") ? " + value + " : 1'bz" : value;
}

}  // namespace

Binding bind(const std::vector<Port>& ports, const Locations& locations,
             const Locations& signals_by_pin) {
    Binding binding;
    std::set<std::string> driven, located;
    std::string nowhere;
    for (const Port& port : ports)
        if (port.direction != Direction::INPUT)
            for (const std::string& wire : located_wires(port, locations, signals_by_pin))
                if (!wire.empty()) located.insert(wire);
    for (const Port& port : ports) {
        std::vector<std::string> wires = located_wires(port, locations, signals_by_pin);
        name_wires(wires, port, located, binding.notes);
        Binding::BoundPort bound{port, {}};
        bool any = false;
        const auto open = std::count(wires.begin(), wires.end(), "");
        for (std::string& wire : wires) {
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
            if (wire.compare(0, 4, "VGA_") == 0) binding.has_vga = true;
            if (wire == "TD_CLK27") binding.has_td_clk = true;
            if (wire == "AUD_XCK" && port.direction != Direction::INPUT) binding.has_xck = true;
            if (port.direction == Direction::OUTPUT &&
                (wire == "AUD_BCLK" || wire == "AUD_DACLRCK" || wire == "AUD_ADCLRCK"))
                binding.drives_codec_clocks = true;
            if (port.direction == Direction::OUTPUT && is_header(wire))
                binding.header_outputs[wire[5] - '0'] |= std::uint64_t{1}
                                                         << std::stoi(wire.substr(7));
            bound.bits.push_back({std::move(wire)});
        }
        if (!any && port.name.compare(0, 4, "HPS_") != 0)
            nowhere += fmt::format("{}{}{}", nowhere.empty() ? "" : ", ", port.name,
                                   port.direction == Direction::INPUT
                                       ? is_low_active(port.name) ? " (is 1)" : " (is 0)"
                                       : "");
        else if (any && open > 0)
            binding.notes.push_back(fmt::format("{}: {} of its {} bits have no pin of the board",
                                                port.name, open, bound.bits.size()));
        binding.ports.push_back(std::move(bound));
    }
    if (!nowhere.empty()) binding.notes.push_back("ports without a pin of the board: " + nowhere);
    return binding;
}

std::string design_text(const Binding& binding, const std::string& top,
                        const std::string& parameters) {
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
                assigns += fmt::format("    assign {} = {};\n", wire,
                                       driver_text(wire, fmt::format("{}[{}]", own, position)));
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
        "// Written by de1sim for the top module {}.\n{}    {}{} de1sim_design (\n{}\n    );\n{}",
        top, wires, top, parameters, ports, assigns);
}

}  // namespace sim::project
