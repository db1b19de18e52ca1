// controls.cpp - masks to names
#include "sim/scenario/controls.h"

#include <cstring>

namespace sim {

namespace {

std::string cap(unsigned n) { return std::string(1, KEYPAD_CAPS[n]); }
std::string key(unsigned n) { return n == HPS_KEY ? "hps" : std::to_string(n); }
std::string digit(unsigned n) { return std::to_string(n); }

// "keypad 1 and 5"; nothing for an empty mask.
std::string name_all(const char* kind, unsigned mask, unsigned count, std::string name(unsigned)) {
    std::string out;
    for (unsigned n = 0; n < count; ++n)
        if (mask >> n & 1) out += (out.empty() ? std::string(kind) + " " : " and ") + name(n);
    return out;
}

}  // namespace

std::optional<unsigned> keypad_key(char cap) {
    const char* at = cap ? std::strchr(KEYPAD_CAPS, cap) : nullptr;
    if (!at) return std::nullopt;
    return static_cast<unsigned>(at - KEYPAD_CAPS);
}

std::vector<unsigned> control_numbers(const Controls& controls) {
    const std::uint64_t all = controls.keypad | std::uint64_t{controls.keys} << KEYPAD_KEYS |
                              std::uint64_t{controls.switches} << (KEYPAD_KEYS + KEYS);
    std::vector<unsigned> numbers;
    for (unsigned n = 0; n < CONTROLS; ++n)
        if (all >> n & 1) numbers.push_back(n);
    return numbers;
}

std::string control_wire(unsigned number) {
    if (number < KEYPAD_KEYS) return "GPIO_0[0]";
    if (number == KEYPAD_KEYS + HPS_KEY) return "HPS";
    if (number < KEYPAD_KEYS + KEYS) return "KEY[" + digit(number - KEYPAD_KEYS) + "]";
    return wire_of(WireGroup::SWITCHES, number - KEYPAD_KEYS - KEYS);
}

std::string control_name(unsigned number) {
    if (number < KEYPAD_KEYS) return "keypad " + cap(number);
    if (number < KEYPAD_KEYS + KEYS) return "key " + key(number - KEYPAD_KEYS);
    return "switch " + digit(number - KEYPAD_KEYS - KEYS);
}

std::string to_string(const Controls& controls) {
    std::string out = name_all("keypad", controls.keypad, KEYPAD_KEYS, cap);
    for (const std::string& part : {name_all("key", controls.keys, KEYS, key),
                                    name_all("switch", controls.switches, SWITCHES, digit)})
        if (!part.empty()) out += (out.empty() ? "" : ", ") + part;
    return out;
}

}  // namespace sim
