#include "sim/project/binding.h"

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "sim/pins/header_pin.h"

namespace sim::project {

namespace {

using Locations = std::map<std::string, std::string>;

// The pins of a board, and where a project puts them.
struct PinMap {
    const BoardDescription& board;
    const Locations& locations;
    const Locations signals_by_pin = board.signals_by_pin();
};

// The signal for bit `bit` of a port, counted from the right, by its name alone.
std::string by_name(const Port& port, int bit, const BoardDescription& board) {
    const BoardSignal* const signal = board.signal(port.name);
    return signal && bit >= 0 && bit < static_cast<int>(signal->width())
               ? signal->bit(static_cast<unsigned>(bit))
               : "";
}

// Of "VGA_R[3]"; null: it is no wire of the chip.
const ChipWires* wires_of(const std::string& wire) {
    return chip_wires_named(std::string_view{wire}.substr(0, wire.find('[')));
}

bool is_of(WireGroup group, const std::string& wire) {
    const ChipWires* const wires = wires_of(wire);
    return wires && wires->group == group;
}

// What to add to a bit of a colour so that the uppermost of `width` is the board's uppermost.
int colour_shift(const Port& port, int width, const BoardDescription& board) {
    const BoardSignal* const signal = board.signal(port.name);
    if (!signal || !is_of(WireGroup::COLOURS, signal->wires.front()) || signal->width() > 8)
        return 0;
    return static_cast<int>(signal->width()) - width;
}

// The signal that a location gives to bit `index`, or empty.
std::string by_location(const Port& port, int index, const PinMap& pins) {
    const auto location =
        pins.locations.find(port.vector ? fmt::format("{}[{}]", port.name, index) : port.name);
    if (location == pins.locations.end()) return {};
    const auto signal = pins.signals_by_pin.find(location->second);
    return signal != pins.signals_by_pin.end() ? signal->second : "";
}

// A port's bits, from the left, as far as locations tell.
std::vector<std::string> located_signals(const Port& port, const PinMap& pins) {
    std::vector<std::string> signals;
    for (int index = port.left;; index += port.left >= port.right ? -1 : 1) {
        signals.push_back(by_location(port, index, pins));
        if (index == port.right) return signals;
    }
}

// Fills in the other bits by the port's name.  A pin that a location gives to another output stays
// that one's.
void name_signals(std::vector<std::string>& signals, const Port& port, const PinMap& pins,
                  const std::set<std::string>& located, std::vector<std::string>& notes) {
    const bool all =
        std::all_of(signals.begin(), signals.end(), [](auto& signal) { return signal.empty(); });
    const int width = static_cast<int>(signals.size());
    for (int i = 0; i < width; ++i) {
        std::string& signal = signals[static_cast<std::size_t>(i)];
        if (!signal.empty()) continue;
        const int bit = port.left >= port.right ? width - 1 - i : i;
        signal = by_name(port, bit + (all ? colour_shift(port, width, pins.board) : 0), pins.board);
        if (port.direction == Direction::INPUT || !located.count(signal)) continue;
        notes.push_back(fmt::format("output {} is on {}, which another output drives: left open",
                                    port.name, signal));
        signal.clear();
    }
}

bool is_low_active(const std::string& port) {
    const std::string name = port.size() > 2 ? port.substr(port.size() - 2) : "";
    return name == "_n" || name == "_N";
}

// Verilator takes a header for driven as a whole as soon as one of its pins is driven always.
std::string driver_text(const std::string& wire, const std::string& value) {
    return is_of(WireGroup::HEADERS, wire) ? "$c1(\"1\") ? " + value + " : 1'bz" : value;
}

// Of a colour with fewer bits than the chip's 8 the others repeat them, so that the brightest is
// the brightest.  Where the board has no clock for the monitor, which then finds the pixels by
// itself, it looks at the colours at each CLOCK_50.
void connect_monitor(const BoardDescription& board, Binding& binding) {
    for (const char* colour : {"VGA_R", "VGA_G", "VGA_B"})
        if (const unsigned width = board.wires_named(colour))
            for (unsigned n = 8 - width; n-- > 0;)
                binding.connected[fmt::format("{}[{}]", colour, n)] =
                    fmt::format("{}[{}]", colour, n + width);
    if (!board.has_wire("VGA_CLK")) binding.connected["VGA_CLK"] = "CLOCK_50";
}

}  // namespace

Binding bind(const std::vector<Port>& ports, const Locations& locations,
             const BoardDescription& board) {
    const PinMap pins{board, locations};
    Binding binding;
    std::set<std::string> driven, located;
    std::string nowhere, passed_over;
    for (const Port& port : ports)
        if (port.direction != Direction::INPUT)
            for (const std::string& signal : located_signals(port, pins))
                if (!signal.empty()) located.insert(signal);
    for (const Port& port : ports) {
        std::vector<std::string> signals = located_signals(port, pins);
        name_signals(signals, port, pins, located, binding.notes);
        Binding::BoundPort bound{port, {}};
        bool any = false, any_wire = false;
        const auto open = std::count(signals.begin(), signals.end(), "");
        for (std::string& name : signals) {
            const BoardSignal* signal = name.empty() ? nullptr : board.signal_of_bit(name);
            if (signal && port.direction == Direction::OUTPUT) {
                if (signal->direction == Direction::INPUT) {
                    binding.notes.push_back(fmt::format(
                        "output {} is on {}, which the board drives: left open", port.name, name));
                    name.clear();
                } else if (!driven.insert(name).second) {
                    binding.notes.push_back(
                        fmt::format("output {} is on {}, which another output drives: left open",
                                    port.name, name));
                    name.clear();
                }
            } else if (signal && port.direction == Direction::INOUT) {
                driven.insert(name);
            }
            const std::string wire = name.empty() ? "" : board.wire_of_bit(name);
            any = any || !name.empty();
            any_wire = any_wire || !wire.empty();
            if (!name.empty() && signal->period_fs) binding.clocks.emplace(signal->name, 0);
            if (is_of(WireGroup::MONITOR, wire) || is_of(WireGroup::COLOURS, wire))
                binding.has_vga = true;
            if (wire == "TD_CLK27") binding.has_td_clk = true;
            if (wire == "AUD_XCK" && port.direction != Direction::INPUT) binding.has_xck = true;
            if (port.direction == Direction::OUTPUT && is_of(WireGroup::CODEC, wire) &&
                wires_of(wire)->direction == Direction::INOUT)
                binding.drives_codec_clocks = true;
            if (const auto pin = header_pin(wire); pin && port.direction == Direction::OUTPUT)
                add(binding.header_outputs, *pin);
            bound.bits.push_back({wire, std::move(name)});
        }
        if (any && !any_wire) passed_over += (passed_over.empty() ? "" : ", ") + port.name;
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
    if (!passed_over.empty())
        binding.notes.push_back(fmt::format("ports on what the {} has, but nothing simulates: {}",
                                            board.name, passed_over));
    if (binding.has_vga) connect_monitor(board, binding);
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
    for (const auto& [clock, pll] : binding.clocks)
        wires += fmt::format("    wire {} = pll_clocks[{}];\n", clock, pll);
    for (const auto& [wire, by] : binding.connected) {
        assigns += fmt::format("    assign {} = {};\n", wire, by);
        driven.insert(wire);
    }
    for (const ChipWires& own : CHIP_WIRES) {
        if (own.direction != Direction::OUTPUT) continue;
        for (unsigned i = 0; i < own.width; ++i)
            if (const std::string wire = own.wire(i); !driven.count(wire))
                assigns += fmt::format("    assign {} = 1'b{};\n", wire,
                                       own.level == ChipWires::HIGH ? 1 : 0);
    }
    return fmt::format(
        "// Written by de1sim for the top module {}.\n{}    {}{} de1sim_design (\n{}\n    );\n{}",
        top, wires, top, parameters, ports, assigns);
}

}  // namespace sim::project
