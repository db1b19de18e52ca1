#include "sim/board/scan_codes.h"

#include <cstring>

namespace sim {

namespace {

constexpr std::uint8_t BREAK = 0xF0, EXTENDED = 0xE0;

// Characters without and with shift, and the key's code.
constexpr char PLAIN[] = "`1234567890-=\tqwertyuiop[]\\asdfghjkl;'\nzxcvbnm,./ ";
constexpr char SHIFTED[] = "~!@#$%^&*()_+\tQWERTYUIOP{}|ASDFGHJKL:\"\nZXCVBNM<>? ";
constexpr std::uint8_t CODES[] = {0x0E, 0x16, 0x1E, 0x26, 0x25, 0x2E, 0x36, 0x3D, 0x3E, 0x46,
                                  0x45, 0x4E, 0x55, 0x0D, 0x15, 0x1D, 0x24, 0x2D, 0x2C, 0x35,
                                  0x3C, 0x43, 0x44, 0x4D, 0x54, 0x5B, 0x5D, 0x1C, 0x1B, 0x23,
                                  0x2B, 0x34, 0x33, 0x3B, 0x42, 0x4B, 0x4C, 0x52, 0x5A, 0x1A,
                                  0x22, 0x21, 0x2A, 0x32, 0x31, 0x3A, 0x41, 0x49, 0x4A, 0x29};
static_assert(sizeof PLAIN == sizeof SHIFTED && sizeof CODES == sizeof PLAIN - 1);

// Keys without a character, or with a name besides it.
const Key NAMED[] = {
    {"Esc", 0x76},         {"F1", 0x05},
    {"F2", 0x06},          {"F3", 0x04},
    {"F4", 0x0C},          {"F5", 0x03},
    {"F6", 0x0B},          {"F7", 0x83},
    {"F8", 0x0A},          {"F9", 0x01},
    {"F10", 0x09},         {"F11", 0x78},
    {"F12", 0x07},         {"PrintScreen", PRINT_SCREEN},
    {"ScrollLock", 0x7E},  {"Pause", PAUSE},
    {"Backspace", 0x66},   {"Tab", 0x0D},
    {"Enter", 0x5A},       {"Space", 0x29},
    {"CapsLock", 0x58},    {"Shift", LEFT_SHIFT},
    {"RightShift", 0x59},  {"Ctrl", 0x14},
    {"RightCtrl", 0xE014}, {"Alt", 0x11},
    {"RightAlt", 0xE011},  {"Win", 0xE01F},
    {"RightWin", 0xE027},  {"Menu", 0xE02F},
    {"Insert", 0xE070},    {"Home", 0xE06C},
    {"PageUp", 0xE07D},    {"Delete", 0xE071},
    {"End", 0xE069},       {"PageDown", 0xE07A},
    {"Up", 0xE075},        {"Left", 0xE06B},
    {"Down", 0xE072},      {"Right", 0xE074},
    {"NumLock", 0x77},     {"NumpadSlash", 0xE04A},
    {"NumpadStar", 0x7C},  {"NumpadMinus", 0x7B},
    {"NumpadPlus", 0x79},  {"NumpadEnter", 0xE05A},
    {"NumpadPoint", 0x71}, {"Numpad0", 0x70},
    {"Numpad1", 0x69},     {"Numpad2", 0x72},
    {"Numpad3", 0x7A},     {"Numpad4", 0x6B},
    {"Numpad5", 0x73},     {"Numpad6", 0x74},
    {"Numpad7", 0x6C},     {"Numpad8", 0x75},
    {"Numpad9", 0x7D},
};

}  // namespace

const std::vector<Key>& keys() {
    static const std::vector<Key> ALL = [] {
        std::vector<Key> all(std::begin(NAMED), std::end(NAMED));
        for (std::size_t i = 0; i < sizeof CODES; ++i)
            if (PLAIN[i] > ' ') all.push_back({std::string(1, PLAIN[i]), CODES[i]});
        return all;
    }();
    return ALL;
}

Codes make_code(std::uint16_t key) {
    if (key == PAUSE) return {0xE1, 0x14, 0x77, 0xE1, 0xF0, 0x14, 0xF0, 0x77};
    if (key == PRINT_SCREEN) return {EXTENDED, LEFT_SHIFT, EXTENDED, 0x7C};
    const auto byte = static_cast<std::uint8_t>(key);
    return key >> 8 ? Codes{EXTENDED, byte} : Codes{byte};
}

Codes repeat_code(std::uint16_t key) {
    if (key == PAUSE) return {};
    if (key == PRINT_SCREEN) return {EXTENDED, 0x7C};
    return make_code(key);
}

Codes break_code(std::uint16_t key) {
    if (key == PAUSE) return {};
    if (key == PRINT_SCREEN) return {EXTENDED, BREAK, 0x7C, EXTENDED, BREAK, LEFT_SHIFT};
    const auto byte = static_cast<std::uint8_t>(key);
    return key >> 8 ? Codes{EXTENDED, BREAK, byte} : Codes{BREAK, byte};
}

std::optional<Stroke> stroke(char character) {
    if (!character) return {};
    const auto place = [character](const char* keys) -> std::optional<std::ptrdiff_t> {
        const char* at = std::strchr(keys, character);
        return at ? std::optional{at - keys} : std::nullopt;
    };
    if (const auto plain = place(PLAIN)) return Stroke{CODES[*plain], false};
    if (const auto shifted = place(SHIFTED)) return Stroke{CODES[*shifted], true};
    return {};
}

}  // namespace sim
