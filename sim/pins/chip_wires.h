// chip_wires.h - the table chip_wires.def in C++: the simulated chip's wires, ports, and what is in
// which bit of which port
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>

namespace sim {

enum class ChipWire {
#define CHIP_WIRE(name, bits, direction, level, pull, group) name,
#include "sim/pins/chip_wires.def"
};

enum class ChipPort {
#define CHIP_PORT(name, kind, bits) name,
#include "sim/pins/chip_wires.def"
};

enum class Direction { INPUT, OUTPUT, INOUT };  // as the chip has it

enum class WireGroup {
    CLOCKS,
    KEYS,
    SWITCHES,
    LAMPS,
    DIGITS,
    HEADERS,
    MONITOR,
    COLOURS,
    SDRAM,
    CODEC,
    I2C,
    CONVERTER,
    ACCELEROMETER,
    PS2,
    INFRARED,
    VIDEO_IN,
    FAN
};

enum class PortKind { AT_ONCE, TAKEN, OUTPUT };

enum class BitsForm { LEVEL, INVERTED, DRIVEN_BY_CHIP, PULLS_LOW, DRIVES };

// Wires of the simulated chip that belong together.
struct ChipWires {
    enum Level { LOW, HIGH };
    enum Pull { NO_PULL, PULL_UP };

    std::string_view name;  // "VGA_R"
    unsigned width;         // 8; 1: written without an index
    Direction direction;
    Level level;  // while nobody has driven it
    Pull pull;
    WireGroup group;

    // "VGA_R[3]", "VGA_HS".
    std::string wire(unsigned index) const {
        return std::string{name} + (width == 1 ? "" : "[" + std::to_string(index) + "]");
    }
};

struct ChipPortForm {
    std::string_view name;
    PortKind kind;
    unsigned own_bits;  // 0: it has those of CHIP_BITS
};

// Bits of a port that are bits of a wire.
struct ChipBits {
    enum Which { ALL, SEGMENTS, POINT };

    ChipPort port;
    BitsForm form;
    ChipWire wire;
    Which which;

    constexpr unsigned first() const { return which == POINT ? 7 : 0; }  // of the wire
    constexpr unsigned count() const;
};

// In the table's order.
constexpr ChipWires CHIP_WIRES[] = {
#define CHIP_WIRE(name, bits, direction, level, pull, group) \
    {#name, bits, Direction::direction, ChipWires::level, ChipWires::pull, WireGroup::group},
#include "sim/pins/chip_wires.def"
};
constexpr ChipPortForm CHIP_PORTS[] = {
#define CHIP_PORT(name, kind, bits) {#name, PortKind::kind, bits},
#include "sim/pins/chip_wires.def"
};
constexpr ChipBits CHIP_BITS_OF_PORTS[] = {
#define CHIP_BITS(port, form, wire, which) \
    {ChipPort::port, BitsForm::form, ChipWire::wire, ChipBits::which},
#include "sim/pins/chip_wires.def"
};

constexpr const ChipWires& row_of(ChipWire wire) { return CHIP_WIRES[static_cast<unsigned>(wire)]; }
constexpr const ChipPortForm& row_of(ChipPort port) {
    return CHIP_PORTS[static_cast<unsigned>(port)];
}

constexpr unsigned ChipBits::count() const {
    return which == SEGMENTS ? 7 : which == POINT ? 1 : row_of(wire).width;
}

// Of a wire's name without an index; null: there is none.
constexpr const ChipWires* chip_wires_named(std::string_view name) {
    for (const ChipWires& wires : CHIP_WIRES)
        if (wires.name == name) return &wires;
    return nullptr;
}

constexpr unsigned bits_of(ChipPort port) {
    unsigned bits = row_of(port).own_bits;
    for (const ChipBits& more : CHIP_BITS_OF_PORTS)
        if (more.port == port) bits += more.count();
    return bits;
}

// At which bit of the port the wire begins; NO_BIT: it is not in it.
constexpr unsigned NO_BIT = ~0u;
constexpr unsigned lsb_of(ChipPort port, ChipWire wire) {
    unsigned lsb = 0;
    for (const ChipBits& bits : CHIP_BITS_OF_PORTS) {
        if (bits.port != port) continue;
        if (bits.wire == wire) return lsb;
        lsb += bits.count();
    }
    return NO_BIT;
}

constexpr unsigned lsb_of(ChipPort port, std::string_view wire) {
    for (unsigned n = 0; n < sizeof CHIP_WIRES / sizeof *CHIP_WIRES; ++n)
        if (CHIP_WIRES[n].name == wire) return lsb_of(port, static_cast<ChipWire>(n));
    return NO_BIT;
}

// How many wires, and how many names of wires, a group has.
constexpr unsigned wires_of(WireGroup group) {
    unsigned count = 0;
    for (const ChipWires& wires : CHIP_WIRES)
        if (wires.group == group) count += wires.width;
    return count;
}
constexpr unsigned names_of(WireGroup group) {
    unsigned count = 0;
    for (const ChipWires& wires : CHIP_WIRES) count += wires.group == group;
    return count;
}

// Wire `number` of a group, in the table's order: LAMPS and 3 is "LEDR[3]".
inline std::string wire_of(WireGroup group, unsigned number) {
    for (const ChipWires& wires : CHIP_WIRES) {
        if (wires.group != group) continue;
        if (number < wires.width) return wires.wire(number);
        number -= wires.width;
    }
    return {};
}

// As Verilator has a port of so many bits.
template <unsigned BITS>
using PortWord = std::conditional_t<
    (BITS <= 8), std::uint8_t,
    std::conditional_t<(BITS <= 16), std::uint16_t,
                       std::conditional_t<(BITS <= 32), std::uint32_t, std::uint64_t>>>;

}  // namespace sim
