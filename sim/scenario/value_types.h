// value_types.h - the kinds of value that a field can have: how to read, describe and complete them
//
// Here are the types that several files use and the building blocks of others.  A type that only
// one file of steps/ uses is in that file.
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

using Numbers = std::vector<std::uint64_t>;
using Value = std::variant<std::uint64_t, double, std::string, SimTime, Numbers>;
using Reading = std::optional<Value>;  // no value: the node is of another type

struct ValueType {
    std::string expected;  // completes "expected ..."
    std::string schema;    // JSON Schema of one value
    std::function<Reading(const YamlNode&)> read;
    std::string list_of = "";  // one value or a list of different numbers, and their name
    std::vector<std::string> words = {};  // for the hint at a typing mistake
    std::size_t at_most = 0;              // entries of a list; 0: no limit
    bool is_path = false;                 // as seen from the scenario's folder
    bool is_opened = false;               // it names a file that the step reads or writes
    // Of a list: numbers of which there may be more, together so many.
    struct Several {
        std::string what;
        Numbers numbers;
        std::size_t at_most;
    };
    std::optional<Several> several = {};
};

namespace value_types {

extern const ValueType LINE, PATH, FILE_NAME, TEXT, TIME, SOME_TIME, HERTZ, TO_USB, PAD;

ValueType whole_number(const std::string& expected, std::uint64_t least, std::uint64_t most);
ValueType decimal_number(const std::string& expected, double least, double most);
// Digits and %, read as a fraction: 0.03 for 3%.
ValueType percent(const std::string& expected, double least, double most);
// From -most to most; Values::number() gives it with its sign.
ValueType signed_number(const std::string& expected, std::uint64_t most);
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

// Throws Refusal, with a hint if only quotes are missing or superfluous.
Value read_value(const ValueType& type, const YamlNode& node);

}  // namespace sim
