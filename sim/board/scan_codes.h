// scan_codes.h - which key of a US keyboard makes a character, by scan code set 2.
#pragma once

#include <cstdint>
#include <optional>

namespace sim {

struct ScanCode {
    std::uint8_t code;  // make; the break code is F0 and this
    bool shift;
};

// For printable ASCII, line feed (Enter) and tab.
std::optional<ScanCode> scan_code(char character);

}  // namespace sim
