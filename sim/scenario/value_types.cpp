// value_types.cpp - one reader a kind of value, and its JSON Schema beside it
#include "sim/scenario/value_types.h"

#include <algorithm>
#include <bitset>
#include <charconv>
#include <string_view>

#include "sim/board/scan_codes.h"
#include "sim/scenario/seven_segment.h"
#include "sim/scenario/words.h"

namespace sim {

namespace {

using Read = std::optional<Value>;

bool is_plain(const YamlNode& node) { return node.kind == YamlNode::Kind::SCALAR && !node.quoted; }

// Decimal without leading zeros, or 0x and hex digits.
std::optional<std::uint64_t> whole(std::string_view text, std::uint64_t least, std::uint64_t most) {
    const bool hex = text.substr(0, 2) == "0x";
    if (hex) text.remove_prefix(2);
    if (text.empty() || (!hex && text.size() > 1 && text[0] == '0')) return std::nullopt;
    std::uint64_t number = 0;
    const auto [end, error] =
        std::from_chars(text.data(), text.data() + text.size(), number, hex ? 16 : 10);
    if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
    if (number < least || number > most) return std::nullopt;
    return number;
}

template <std::uint64_t least, std::uint64_t most>
Read read_whole(const YamlNode& node) {
    if (!is_plain(node)) return std::nullopt;
    if (const auto number = whole(node.text, least, most)) return *number;
    return std::nullopt;
}

// Digits, perhaps a point and more digits.
std::optional<double> decimal(std::string_view text, double least, double most) {
    if (text.empty() || text.find_first_not_of("0123456789.") != text.npos || text[0] == '.' ||
        text.back() == '.' || (text.size() > 1 && text[0] == '0' && text[1] != '.'))
        return std::nullopt;
    double number = 0;
    const auto [end, error] =
        std::from_chars(text.data(), text.data() + text.size(), number, std::chars_format::fixed);
    if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
    if (number < least || number > most) return std::nullopt;
    return number;
}

Read read_text(const YamlNode& node) {
    if (!is_text(node) || node.text.empty()) return std::nullopt;
    return node.text;
}

Read read_keys(const YamlNode& node) {
    if (!std::all_of(node.text.begin(), node.text.end(), [](char c) { return scan_code(c); }))
        return std::nullopt;
    return read_text(node);
}

Read read_line(const YamlNode& node) {
    const auto is_control = [](char c) { return (c >= 0 && c < 0x20) || c == 0x7F; };
    if (std::any_of(node.text.begin(), node.text.end(), is_control)) return std::nullopt;
    return read_text(node);
}

Read read_png_name(const YamlNode& node) {
    const auto value = read_line(node);
    if (!value) return std::nullopt;
    const std::filesystem::path path(node.text);
    const bool climbs = std::find(path.begin(), path.end(), "..") != path.end();
    if (path.is_absolute() || climbs || path.extension() != ".png") return std::nullopt;
    return value;
}

Read read_time(const YamlNode& node) {
    if (!is_text(node)) return std::nullopt;
    if (const auto time = SimTime::parse(node.text)) return *time;
    return std::nullopt;
}

Read read_some_time(const YamlNode& node) {
    const auto value = read_time(node);
    return value && std::get<SimTime>(*value).ps == 0 ? std::nullopt : value;
}

Read read_percent(const YamlNode& node) {
    const std::string_view text = node.text;
    if (!is_text(node) || text.empty() || text.back() != '%') return std::nullopt;
    const auto percent = decimal(text.substr(0, text.size() - 1), 0.01, 50);
    if (!percent) return std::nullopt;
    return *percent / 100;
}

Read read_hertz(const YamlNode& node) {
    if (!is_plain(node)) return std::nullopt;
    if (const auto hz = decimal(node.text, 20, 20000)) return *hz;
    return std::nullopt;
}

Read read_volts(const YamlNode& node) {
    if (!is_plain(node)) return std::nullopt;
    if (const auto volts = decimal(node.text, 0, 5)) return *volts;
    return std::nullopt;
}

Read read_frame(const YamlNode& node) {
    if (node.text == "next") return WaitFrame{WaitFrame::What::NEXT, 0, {}};
    if (node.text == "next-swap") return WaitFrame{WaitFrame::What::NEXT_SWAP, 0, {}};
    if (const auto number = is_plain(node) ? whole(node.text, 1, 1'000'000) : std::nullopt)
        return WaitFrame{WaitFrame::What::NUMBER, *number, {}};
    return std::nullopt;
}

Read read_keypad(const YamlNode& node) {
    const auto key = node.text.size() == 1 ? keypad_key(node.text[0]) : std::nullopt;
    if (!key) return std::nullopt;
    return std::uint64_t{*key};
}

Read read_leds(const YamlNode& node) {
    if (!node.quoted) return read_whole<0, 1023>(node);
    if (node.text.size() != 10 || node.text.find_first_not_of("01") != node.text.npos)
        return std::nullopt;
    return std::uint64_t{std::bitset<10>(node.text).to_ulong()};
}

Read read_hex(const YamlNode& node) {
    if (!is_text(node) || !is_hex_text(node.text)) return std::nullopt;
    return node.text;
}

#define TIME_PATTERN "[0-9]+(\\\\.[0-9]+)?(s|ms|us|ns)$"

}  // namespace

namespace value_types {

const ValueType LINE{"a line of text",
                     R"({"type": "string", "pattern": "^[^\\u0000-\\u001f\\u007f]+$"})", read_line};
const ValueType TEXT{"text", R"({"type": "string", "minLength": 1})", read_text};
const ValueType KEYS_TEXT{"text of characters that a US keyboard has",
                          R"({"type": "string", "pattern": "^[\\t\\n -~]+$"})", read_keys};
const ValueType PNG_NAME{
    "a name such as start.png inside the output folder",
    R"({"type": "string", "pattern": "^(?!/)(?!(.*/)?\\.\\.(/|$))[^\\u0000-\\u001f\\u007f]*)"
    R"([^/\\u0000-\\u001f\\u007f]\\.png$"})",
    read_png_name};
const ValueType VERSION{"1, the version of the format", R"({"type": "integer", "const": 1})",
                        read_whole<1, 1>};
const ValueType SEED{"a whole number from 0 to 18446744073709551615",
                     R"({"type": "integer", "minimum": 0, "maximum": 18446744073709551615})",
                     read_whole<0, UINT64_MAX>};
const ValueType PIXELS{"a whole number from 0 to 307200",
                       R"({"type": "integer", "minimum": 0, "maximum": 307200})",
                       read_whole<0, 307200>};
const ValueType TIME{"a time such as 500ms (s, ms, us or ns, up to an hour)",
                     "{\"type\": \"string\", \"pattern\": \"^" TIME_PATTERN "\"}", read_time};
const ValueType SOME_TIME{"a time above 0 such as 500ms (s, ms, us or ns, up to an hour)",
                          "{\"type\": \"string\", \"pattern\": \"^(?=.*[1-9])" TIME_PATTERN "\"}",
                          read_some_time};
const ValueType PERCENT{"a percentage such as 3%, from 0.01% to 50%",
                        R"({"type": "string", "pattern": "^(0|[1-9][0-9]*)(\\.[0-9]+)?%$"})",
                        read_percent};
const ValueType HERTZ{"a frequency in hertz, 20 to 20000",
                      R"({"type": "number", "minimum": 20, "maximum": 20000})", read_hertz};
const ValueType FRAME{"a frame number from 1 to 1000000, next or next-swap",
                      R"({"anyOf": [{"type": "integer", "minimum": 1, "maximum": 1000000},
                  {"enum": ["next", "next-swap"]}]})",
                      read_frame};
const ValueType KEYPAD{
    "a keypad key, 0-9 or A-F",
    R"({"enum": ["0", "1", "2", "3", "4", "5", "6", "7", "8", "9", "A", "B", "C", "D", "E", "F",
                 0, 1, 2, 3, 4, 5, 6, 7, 8, 9]})",
    read_keypad, true};
const ValueType KEY{"a key number, 0 to 3", R"({"type": "integer", "minimum": 0, "maximum": 3})",
                    read_whole<0, KEYS - 1>, true};
const ValueType SWITCH{"a switch number, 0 to 9",
                       R"({"type": "integer", "minimum": 0, "maximum": 9})",
                       read_whole<0, SWITCHES - 1>, true};
const ValueType CHANNEL{"a channel number, 0 to 7",
                        R"({"type": "integer", "minimum": 0, "maximum": 7})", read_whole<0, 7>};
const ValueType VOLTS{"a number of volts, 0 to 5",
                      R"({"type": "number", "minimum": 0, "maximum": 5})", read_volts};
const ValueType LEDS{"ten characters 0 or 1, LEDR9 first, or a number from 0 to 1023",
                     R"({"anyOf": [{"type": "string", "pattern": "^[01]{10}$"},
                                   {"type": "integer", "minimum": 0, "maximum": 1023}]})",
                     read_leds};
const ValueType HEX{"six characters, HEX5 first, of 0-9 A-F H L P U n o r t u y - _ and blank",
                    R"({"type": "string", "pattern": "^[0-9A-FHLPUnortuy _-]{6}$"})", read_hex};
const ValueType STEPS{"a list of steps", nullptr, nullptr};

}  // namespace value_types

namespace {

[[noreturn]] void refuse_value(const ValueType& type, const YamlNode& node) {
    YamlNode other = node;
    other.quoted = !node.quoted;
    std::string hint;
    if (node.kind == YamlNode::Kind::SCALAR && type.read(other))
        hint = node.quoted ? " (leave out the quotes)" : " (put it in quotes)";
    else if (&type == &value_types::FRAME)
        hint = did_you_mean(node.text, {"next", "next-swap"});
    refuse(node, type.expected, describe(node) + hint);
}

Value read_one(const ValueType& type, const YamlNode& node) {
    if (node.kind == YamlNode::Kind::SCALAR)
        if (auto value = type.read(node)) return *std::move(value);
    refuse_value(type, node);
}

}  // namespace

Value read_value(const ValueType& type, const YamlNode& node) {
    if (!type.set) return read_one(type, node);
    const bool is_list = node.kind == YamlNode::Kind::LIST;
    if (is_list && node.items.empty()) refuse(node, type.expected, "an empty list");
    std::uint64_t mask = 0;
    for (const YamlNode& item : is_list ? node.items : std::vector<YamlNode>{node}) {
        const auto bit = std::uint64_t{1} << std::get<std::uint64_t>(read_one(type, item));
        if (mask & bit) refuse(item, "each control once", describe(item) + " again");
        mask |= bit;
    }
    return mask;
}

}  // namespace sim
