// controls.h - the controls that can be held: keypad keys, KEY3-KEY0, HPS_KEY, SWs
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sim/pins/pins.h"

namespace sim {

// The keypad's caps by key number, 4 * row + column.
constexpr char KEYPAD_CAPS[] = "123A456B789C0FED";
constexpr unsigned KEYPAD_KEYS = 16;
constexpr unsigned HPS_KEY = 4;  // among the KEYs
constexpr unsigned KEYS = 5;

// Masks: bit n is keypad key number n, KEYn or HPS_KEY, SWn.
struct Controls {
    std::uint16_t keypad = 0;
    std::uint8_t keys = 0;
    std::uint32_t switches = 0;

    bool operator==(const Controls& other) const {
        return keypad == other.keypad && keys == other.keys && switches == other.switches;
    }
};

// The key number of a cap, 0-9 or A-F.
std::optional<unsigned> keypad_key(char cap);

// One number for each control: keypad keys, then KEYs, then switches.
constexpr unsigned CONTROLS = KEYPAD_KEYS + KEYS + SWITCHES;
std::vector<unsigned> control_numbers(const Controls& controls);
// The wire of the simulated chip that it is on: "KEY[0]"; "HPS".  Of the keypad a pin of JP1.
std::string control_wire(unsigned number);
std::string control_name(unsigned number);  // "keypad 5", "key 0", "key hps", "switch 3"

// "keypad 5", "keypad 1 and 5, key 0".
std::string to_string(const Controls& controls);

}  // namespace sim
