// value_types.cpp - one reader per kind of value, with its JSON Schema
#include "sim/scenario/value_types.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <filesystem>

#include "sim/board/usb_ports.h"
#include "sim/text/words.h"

namespace sim {

bool is_plain(const YamlNode& node) { return node.kind == YamlNode::Kind::SCALAR && !node.quoted; }

std::optional<std::uint64_t> parse_whole(std::string_view text, std::uint64_t least,
                                         std::uint64_t most) {
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

std::optional<double> parse_decimal(std::string_view text, double least, double most) {
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

namespace {

Reading read_text(const YamlNode& node) {
    if (!is_text(node) || node.text.empty()) return std::nullopt;
    return node.text;
}

Reading read_line(const YamlNode& node) {
    const auto is_control = [](char c) { return (c >= 0 && c < 0x20) || c == 0x7F; };
    if (std::any_of(node.text.begin(), node.text.end(), is_control)) return std::nullopt;
    return read_text(node);
}

// Not of what can only be a folder.
Reading read_file_name(const YamlNode& node) {
    const auto name = std::filesystem::path{node.text}.filename();
    if (name.empty() || name == "." || name == "..") return std::nullopt;
    return read_line(node);
}

Reading read_time(const YamlNode& node) {
    if (!is_text(node)) return std::nullopt;
    if (const auto time = SimTime::parse(node.text)) return *time;
    return std::nullopt;
}

Reading read_some_time(const YamlNode& node) {
    const auto value = read_time(node);
    return value && std::get<SimTime>(*value).ps == 0 ? std::nullopt : value;
}

#define TIME_PATTERN "[0-9]+(\\\\.[0-9]+)?(s|ms|us|ns)$"

}  // namespace

namespace value_types {

const ValueType LINE{"a line of text",
                     R"({"type": "string", "pattern": "^[^\\u0000-\\u001f\\u007f]+$"})", read_line};
const ValueType PATH = [] {
    ValueType type = LINE;
    type.expected = "the name of a file or folder";
    type.is_path = true;
    return type;
}();
const ValueType FILE_NAME = [] {
    ValueType type = PATH;
    type.expected = "a file's name";
    type.is_opened = true;
    type.read = read_file_name;
    return type;
}();
const ValueType TEXT{"text", R"({"type": "string", "minLength": 1})", read_text};
const ValueType TIME{"a time such as 500ms (s, ms, us or ns, up to an hour)",
                     "{\"type\": \"string\", \"pattern\": \"^" TIME_PATTERN "\"}", read_time};
const ValueType SOME_TIME{"a time above 0 such as 500ms (s, ms, us or ns, up to an hour)",
                          "{\"type\": \"string\", \"pattern\": \"^(?=.*[1-9])" TIME_PATTERN "\"}",
                          read_some_time};

const ValueType TO_USB = word("usb", {"usb"});

ValueType whole_number(const std::string& expected, std::uint64_t least, std::uint64_t most) {
    return {expected,
            fmt::format(R"({{"type": "integer", "minimum": {}, "maximum": {}}})", least, most),
            [least, most](const YamlNode& node) -> Reading {
                if (!is_plain(node)) return std::nullopt;
                if (const auto number = parse_whole(node.text, least, most)) return *number;
                return std::nullopt;
            }};
}

ValueType signed_number(const std::string& expected, std::uint64_t most) {
    return {expected,
            fmt::format(R"({{"type": "integer", "minimum": -{0}, "maximum": {0}}})", most),
            [most](const YamlNode& node) -> Reading {
                if (!is_plain(node)) return std::nullopt;
                const bool minus = node.text.substr(0, 1) == "-";
                const auto size = parse_whole(node.text.substr(minus), minus, most);
                if (!size) return std::nullopt;
                return minus ? std::uint64_t{0} - *size : *size;
            }};
}

ValueType decimal_number(const std::string& expected, double least, double most) {
    return {
        expected, fmt::format(R"({{"type": "number", "minimum": {}, "maximum": {}}})", least, most),
        [least, most](const YamlNode& node) -> Reading {
            if (!is_plain(node)) return std::nullopt;
            const bool minus = least < 0 && !node.text.empty() && node.text[0] == '-';
            const std::string_view digits = std::string_view{node.text}.substr(minus);
            const auto number = parse_decimal(digits, std::max(least, 0.0), minus ? -least : most);
            if (!number) return std::nullopt;
            return minus ? -*number : *number;
        }};
}

ValueType percent(const std::string& expected, double least, double most) {
    return {expected, R"({"type": "string", "pattern": "^(0|[1-9][0-9]*)(\\.[0-9]+)?%$"})",
            [least, most](const YamlNode& node) -> Reading {
                const std::string_view text = node.text;
                if (!is_text(node) || text.empty() || text.back() != '%') return std::nullopt;
                const auto number = parse_decimal(text.substr(0, text.size() - 1), least, most);
                if (!number) return std::nullopt;
                return *number / 100;
            }};
}

ValueType word(const std::string& expected, const std::vector<std::string>& words) {
    return {expected,
            fmt::format(R"({{"type": "string", "enum": ["{}"]}})", fmt::join(words, R"(", ")")),
            [words](const YamlNode& node) -> Reading {
                const auto at = std::find(words.begin(), words.end(), node.text);
                if (!is_text(node) || at == words.end()) return std::nullopt;
                return static_cast<std::uint64_t>(at - words.begin());
            },
            "", words};
}

const ValueType PAD = whole_number("the number of a gamepad, 1 or 2", 1, UsbPlugs::GAMEPADS);
const ValueType HERTZ = decimal_number("a frequency in hertz, 20 to 20000", 20, 20000);

}  // namespace value_types

namespace {

[[noreturn]] void refuse_value(const ValueType& type, const YamlNode& node) {
    YamlNode other = node;
    other.quoted = !node.quoted;
    const bool scalar = node.kind == YamlNode::Kind::SCALAR;
    std::string hint = did_you_mean(scalar ? node.text : "", type.words);
    if (scalar && type.read(other))
        hint = node.quoted ? " (leave out the quotes)" : " (put it in quotes)";
    refuse(node, type.expected, describe(node) + hint);
}

Value read_one(const ValueType& type, const YamlNode& node) {
    if (node.kind == YamlNode::Kind::SCALAR)
        if (auto value = type.read(node)) return *std::move(value);
    refuse_value(type, node);
}

}  // namespace

Value read_value(const ValueType& type, const YamlNode& node) {
    if (type.list_of.empty()) return read_one(type, node);
    const bool is_list = node.kind == YamlNode::Kind::LIST;
    if (is_list && node.items.empty()) refuse(node, type.expected, "an empty list");
    if (type.at_most && node.items.size() > type.at_most)
        refuse(node, fmt::format("at most {} in a list", type.at_most),
               std::to_string(node.items.size()));
    Numbers numbers;
    for (const YamlNode& item : is_list ? node.items : std::vector<YamlNode>{node}) {
        const auto number = std::get<std::uint64_t>(read_one(type, item));
        const auto is_of = [](const Numbers& all, std::uint64_t one) {
            return std::count(all.begin(), all.end(), one) > 0;
        };
        if (type.several && is_of(type.several->numbers, number)) {
            const auto before = std::count_if(numbers.begin(), numbers.end(), [&](auto other) {
                return is_of(type.several->numbers, other);
            });
            if (static_cast<std::size_t>(before) == type.several->at_most)
                refuse(item, type.several->what, "one more");
        } else if (is_of(numbers, number)) {
            refuse(item, "each " + type.list_of + " once", describe(item) + " again");
        }
        numbers.push_back(number);
    }
    return numbers;
}

}  // namespace sim
