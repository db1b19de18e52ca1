// header_pin.h - one of the 72 pins of both headers by its number: GPIO_1[3] is 36 + 3
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sim/pins/pins.h"

namespace sim {

using HeaderPin = unsigned;
using HeaderPinList = std::vector<HeaderPin>;

constexpr unsigned PINS_OF_A_HEADER = 36;

inline std::string pin_name(HeaderPin pin) {
    return "GPIO_" + std::to_string(pin / PINS_OF_A_HEADER) + "[" +
           std::to_string(pin % PINS_OF_A_HEADER) + "]";
}

inline bool is_high(const HeaderMasks& levels, HeaderPin pin) {
    return levels[pin / PINS_OF_A_HEADER] >> pin % PINS_OF_A_HEADER & 1;
}

inline HeaderMasks mask_of(const HeaderPinList& pins) {
    HeaderMasks mask{};
    for (const HeaderPin pin : pins)
        mask[pin / PINS_OF_A_HEADER] |= std::uint64_t{1} << pin % PINS_OF_A_HEADER;
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
