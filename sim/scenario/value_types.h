// value_types.h - the kinds of value that a field can have: how to read, describe and complete them
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>

#include "sim/scenario/scenario.h"
#include "sim/scenario/yaml_tree.h"

namespace sim {

using Value = std::variant<std::uint64_t, double, std::string, SimTime, WaitFrame>;

struct ValueType {
    const char* expected;                           // completes "expected ..."
    const char* schema;                             // JSON Schema of one value
    std::optional<Value> (*read)(const YamlNode&);  // nothing: not such a value
    bool set = false;  // one value or a list: numbers, read into a bit mask
};

namespace value_types {

extern const ValueType LINE, TEXT, KEYS_TEXT, PNG_NAME, VERSION, SEED, PIXELS, TIME, SOME_TIME,
    PERCENT, HERTZ, FRAME, KEYPAD, KEY, SWITCH, LEDS, HEX;
extern const ValueType STEPS;  // has no read: reader.cpp reads the list

}  // namespace value_types

// Throws Refusal, with a hint when quotes are all that is wrong.
Value read_value(const ValueType& type, const YamlNode& node);

}  // namespace sim
