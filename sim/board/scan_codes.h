// scan_codes.h - the keys of a US keyboard with 104 keys, by scan code set 2.
//
// A key's code is the byte that it sends, or E0 in the upper byte for those that send E0 before it.
//
//   goes down   code                  Pause: E1 14 77 E1 F0 14 F0 77, and nothing more
//   is held     code again            PrintScreen: E0 12 E0 7C; E0 7C; E0 F0 7C E0 F0 12
//   comes up    [E0] F0 and the byte
//
// Source: Microsoft, Keyboard Scan Code Specification, revision 1.3a.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sim {

constexpr std::uint16_t LEFT_SHIFT = 0x12, PRINT_SCREEN = 0xE07C, PAUSE = 0xE177;

struct Key {
    std::string name;  // the character that it makes without Shift, or a word: "a", "Left"
    std::uint16_t code;
};

const std::vector<Key>& keys();

using Codes = std::vector<std::uint8_t>;
Codes make_code(std::uint16_t key);
Codes repeat_code(std::uint16_t key);
Codes break_code(std::uint16_t key);

// What to strike for a character.
struct Stroke {
    std::uint16_t key;
    bool shift;
};

// For printable ASCII, line feed (Enter) and tab.
std::optional<Stroke> stroke(char character);

}  // namespace sim
