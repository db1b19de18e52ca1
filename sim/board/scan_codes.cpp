#include "sim/board/scan_codes.h"

#include <cstring>

namespace sim {

namespace {

// Characters without and with shift, and the key's code in set 2.
constexpr char PLAIN[] = "`1234567890-=\tqwertyuiop[]\\asdfghjkl;'\nzxcvbnm,./ ";
constexpr char SHIFTED[] = "~!@#$%^&*()_+\tQWERTYUIOP{}|ASDFGHJKL:\"\nZXCVBNM<>? ";
constexpr std::uint8_t CODES[] = {0x0E, 0x16, 0x1E, 0x26, 0x25, 0x2E, 0x36, 0x3D, 0x3E, 0x46,
                                  0x45, 0x4E, 0x55, 0x0D, 0x15, 0x1D, 0x24, 0x2D, 0x2C, 0x35,
                                  0x3C, 0x43, 0x44, 0x4D, 0x54, 0x5B, 0x5D, 0x1C, 0x1B, 0x23,
                                  0x2B, 0x34, 0x33, 0x3B, 0x42, 0x4B, 0x4C, 0x52, 0x5A, 0x1A,
                                  0x22, 0x21, 0x2A, 0x32, 0x31, 0x3A, 0x41, 0x49, 0x4A, 0x29};
static_assert(sizeof PLAIN == sizeof SHIFTED && sizeof CODES == sizeof PLAIN - 1);

}  // namespace

std::optional<ScanCode> scan_code(char character) {
    if (!character) return {};
    const auto place = [character](const char* keys) -> std::optional<std::ptrdiff_t> {
        const char* at = std::strchr(keys, character);
        return at ? std::optional{at - keys} : std::nullopt;
    };
    if (const auto plain = place(PLAIN)) return ScanCode{CODES[*plain], false};
    if (const auto shifted = place(SHIFTED)) return ScanCode{CODES[*shifted], true};
    return {};
}

}  // namespace sim
