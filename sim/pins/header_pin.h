// header_pin.h - one of the pins of the headers by its number: GPIO_1[3] is 36 + 3
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/pins/pins.h"

namespace sim {

using HeaderPin = unsigned;
using HeaderPinList = std::vector<HeaderPin>;

constexpr unsigned PINS_OF_A_HEADER = 36;

// The wires of a header.
constexpr const ChipWires& header_wires(unsigned header) {
    for (const ChipWires& wires : CHIP_WIRES)
        if (wires.group == WireGroup::HEADERS && header-- == 0) return wires;
    return CHIP_WIRES[0];  // there is no such header
}

constexpr unsigned header_of(ChipWire wire) {
    unsigned header = 0;
    while (&header_wires(header) != &row_of(wire)) ++header;
    return header;
}

// All pins of a header, from bit 0.
constexpr std::uint64_t pins_of(ChipWire header) {
    return (std::uint64_t{1} << row_of(header).width) - 1;
}

inline std::string pin_name(HeaderPin pin) {
    return header_wires(pin / PINS_OF_A_HEADER).wire(pin % PINS_OF_A_HEADER);
}

// Of a wire of the chip, "GPIO_1[3]"; nothing: it is on no header.
inline std::optional<HeaderPin> header_pin(std::string_view wire) {
    const std::size_t bracket = wire.find('[');
    for (unsigned header = 0; header < HEADERS; ++header)
        if (bracket != wire.npos && header_wires(header).name == wire.substr(0, bracket))
            return header * PINS_OF_A_HEADER +
                   static_cast<unsigned>(std::stoul(std::string{wire.substr(bracket + 1)}));
    return {};
}

inline bool is_high(const HeaderMasks& levels, HeaderPin pin) {
    return levels[pin / PINS_OF_A_HEADER] >> pin % PINS_OF_A_HEADER & 1;
}

inline void add(HeaderMasks& mask, HeaderPin pin) {
    mask[pin / PINS_OF_A_HEADER] |= std::uint64_t{1} << pin % PINS_OF_A_HEADER;
}

inline HeaderMasks mask_of(const HeaderPinList& pins) {
    HeaderMasks mask{};
    for (const HeaderPin pin : pins) add(mask, pin);
    return mask;
}

// Of a list of at most 64 pins as one number; the first pin is bit 0.
inline std::uint64_t gathered(const HeaderMasks& levels, const HeaderPinList& pins) {
    std::uint64_t number = 0;
    for (unsigned n = 0; n < pins.size(); ++n)
        number |= std::uint64_t{is_high(levels, pins[n])} << n;
    return number;
}

}  // namespace sim
