// value_types.h - the kinds of value that a field can have: how to read, describe and complete them
//
// Here are those of several files and what others are made of; one that only a file of steps/ has
// is in that file.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "sim/scenario/sim_time.h"
#include "sim/scenario/yaml_tree.h"

namespace sim {

using Value = std::variant<std::uint64_t, double, std::string, SimTime>;
using Reading = std::optional<Value>;  // nothing: not such a value

struct ValueType {
    std::string expected;  // completes "expected ..."
    std::string schema;    // JSON Schema of one value
    std::function<Reading(const YamlNode&)> read;
    bool set = false;                     // one value or a list: numbers, read into a bit mask
    std::vector<std::string> words = {};  // for the hint at a slip
};

namespace value_types {

extern const ValueType LINE, TEXT, TIME, SOME_TIME;

ValueType whole_number(const std::string& expected, std::uint64_t least, std::uint64_t most);
ValueType decimal_number(const std::string& expected, double least, double most);
// One of these words, read as its place in the list.
ValueType word(const std::string& expected, const std::vector<std::string>& words);

}  // namespace value_types

// ---- Parts of readers ----

// Not in quotes.
bool is_plain(const YamlNode& node);
// Decimal without leading zeros, or 0x and hex digits.
std::optional<std::uint64_t> parse_whole(std::string_view text, std::uint64_t least,
                                         std::uint64_t most);
// Digits, perhaps a point and more digits.
std::optional<double> parse_decimal(std::string_view text, double least, double most);

// Throws Refusal, with a hint when quotes are all that is wrong.
Value read_value(const ValueType& type, const YamlNode& node);

}  // namespace sim
