#include "sim/project/chip_text.h"

#include <algorithm>
#include <optional>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "sim/pins/chip_wires.h"
#include "sim/pins/header_pin.h"

namespace sim::project {

namespace {

constexpr const char* FROM = "// Written by de1sim from its table chip_wires.def.\n";

// "[35:0] ", or nothing for a single bit.
std::string range(unsigned bits) { return bits == 1 ? "" : fmt::format("[{}:0] ", bits - 1); }

// Bits of `name`, which has `all`.
std::string slice(std::string_view name, unsigned all, unsigned first, unsigned bits) {
    if (bits == all) return std::string{name};
    return bits == 1 ? fmt::format("{}[{}]", name, first)
                     : fmt::format("{}[{}:{}]", name, first + bits - 1, first);
}

// "gpio_0_low" of the port gpio_0_low_i: what has been taken over from it.
std::string taken(ChipPort port) {
    const std::string_view name = row_of(port).name;
    return std::string{name.substr(0, name.size() - 2)};
}

// A wire's bits in a port; nothing: that kind of port has none of it.
struct Place {
    ChipBits bits;
    unsigned lsb;

    std::string in(std::string_view name) const {
        return slice(name, bits_of(bits.port), lsb, bits.count());
    }
};

std::optional<Place> input_of(ChipWire wire) {
    for (const ChipBits& bits : CHIP_BITS_OF_PORTS)
        if (bits.wire == wire && row_of(bits.port).kind != PortKind::OUTPUT)
            return Place{bits, lsb_of(bits.port, wire)};
    return {};
}

std::string constant(const ChipWires& wires) {
    return fmt::format("{{{}{{1'b{}}}}}", wires.width, wires.level == ChipWires::HIGH ? 1 : 0);
}

class WiresText {
public:
    std::string run(const HeaderMasks& outputs) {
        for (unsigned n = 0; n < std::size(CHIP_PORTS); ++n) keep(static_cast<ChipPort>(n));
        for (unsigned n = 0; n < std::size(CHIP_WIRES); ++n) declare(static_cast<ChipWire>(n));
        for (unsigned n = 0; n < std::size(CHIP_PORTS); ++n)
            show(static_cast<ChipPort>(n), outputs);
        return FROM + declared_ + "    always @(posedge moved_i or negedge moved_i) begin\n" +
               taken_ + "    end\n" + driven_ + shown_;
    }

private:
    // What is not itself a wire, as of the last change of moved_i.
    void keep(ChipPort port) {
        const ChipPortForm& row = row_of(port);
        if (row.kind != PortKind::TAKEN) return;
        for (const ChipBits& bits : CHIP_BITS_OF_PORTS)
            if (bits.port == port && bits.form == BitsForm::LEVEL) return;
        declared_ += fmt::format("    reg {}{} = {}'d0;\n", range(bits_of(port)), taken(port),
                                 bits_of(port));
        taken_ += fmt::format("        {} <= {};\n", taken(port), row.name);
    }

    void declare(ChipWire wire) {
        const ChipWires& row = row_of(wire);
        if (row.group == WireGroup::CLOCKS) return;
        const auto input = input_of(wire);
        const bool is_taken = input && input->bits.form == BitsForm::LEVEL &&
                              row_of(input->bits.port).kind == PortKind::TAKEN;
        std::string value;
        if (is_taken || (row.direction == Direction::INPUT && !input))
            value = " = " + constant(row);
        else if (row.direction == Direction::INPUT)
            value = " = " + input->in(row_of(input->bits.port).name);
        declared_ += fmt::format("    {} {}{}{};\n", is_taken ? "reg" : "wire", range(row.width),
                                 row.name, value);
        if (is_taken)
            taken_ += fmt::format("        {} <= {};\n", row.name,
                                  input->in(row_of(input->bits.port).name));
        for (unsigned n = 0; n < row.width && row.pull == ChipWires::PULL_UP; ++n)
            driven_ += fmt::format("    pullup({});\n", row.wire(n));
        if (row.direction == Direction::INOUT && input) drive(row, *input);
    }

    void drive(const ChipWires& row, const Place& input) {
        const std::string from = taken(input.bits.port);
        if (input.bits.form == BitsForm::DRIVES) {
            driven_ += fmt::format("    assign {} = {}_en ? {} : {}'bz;\n", row.name, from,
                                   input.in(from), row.width);
            return;
        }
        for (unsigned n = 0; n < row.width; ++n)
            driven_ += fmt::format("    assign {} = {} ? 1'b0 : 1'bz;\n", row.wire(n),
                                   slice(from, bits_of(input.bits.port), input.lsb + n, 1));
    }

    void show(ChipPort port, const HeaderMasks& outputs) {
        std::vector<std::string> parts;
        for (const ChipBits& bits : CHIP_BITS_OF_PORTS)
            if (bits.port == port) parts.push_back(shown(bits, outputs));
        if (row_of(port).kind != PortKind::OUTPUT || parts.empty()) return;
        std::reverse(parts.begin(), parts.end());
        shown_ += fmt::format("    assign {} = {{{}}};\n", row_of(port).name,
                              fmt::join(parts, ",\n        "));
    }

    static std::string shown(const ChipBits& bits, const HeaderMasks& outputs) {
        const ChipWires& row = row_of(bits.wire);
        const std::string wire = slice(row.name, row.width, bits.first(), bits.count());
        if (bits.form == BitsForm::INVERTED) return "~" + wire;
        if (bits.form != BitsForm::DRIVEN_BY_CHIP) return wire;
        const auto low = input_of(bits.wire);
        return fmt::format("{}'d{} | ~{} & ~{}", row.width, outputs[header_of(bits.wire)], wire,
                           low->in(taken(low->bits.port)));
    }

    std::string declared_, taken_, driven_, shown_;
};

}  // namespace

std::string chip_ports_text() {
    std::string text;
    for (unsigned n = 0; n < std::size(CHIP_PORTS); ++n) {
        const bool is_output = CHIP_PORTS[n].kind == PortKind::OUTPUT;
        text += fmt::format("{}    {} wire {}{}", n ? ",\n" : FROM, is_output ? "output" : "input",
                            range(bits_of(static_cast<ChipPort>(n))), CHIP_PORTS[n].name);
    }
    return text + "\n";
}

std::string chip_wires_text(const HeaderMasks& outputs) { return WiresText{}.run(outputs); }

}  // namespace sim::project
