#include "sim/scenario/part_form.h"

#include <cstdio>

#include <fmt/format.h>

#include "sim/text/pattern.h"

namespace sim {

namespace {

const std::string NUMBER = "([0-9]|[12][0-9]|3[0-5])", TO_15 = "([0-9]|1[0-5])";
const std::string ONE_PIN = "(GPIO_[01]\\[" + NUMBER + "\\]|ARDUINO_IO\\[" + TO_15 + "\\])";
const std::string PIN_RANGE = "(GPIO_[01]\\[" + NUMBER + "(:" + NUMBER + ")?\\]|ARDUINO_IO\\[" +
                              TO_15 + "(:" + TO_15 + ")?\\])";
const std::string PIN_LIST = PIN_RANGE + "(, *" + PIN_RANGE + ")*";
const std::string NAME = "[A-Za-z][A-Za-z0-9_-]*";

// "GPIO_1[15:8], GPIO_0[3]", from the left.
Reading read_pin_list(const YamlNode& node) {
    static const Pattern LIST{PIN_LIST};
    if (!is_text(node) || !LIST.matches(node.text)) return std::nullopt;
    Numbers pins;
    const std::string& text = node.text;
    for (std::size_t at = 0; at < text.size();) {
        at = text.find_first_not_of(", ", at);
        const std::size_t end = text.find(']', at);
        const std::string name = text.substr(at, text.find('[', at) - at);
        unsigned first = 0, last = 0;
        if (std::sscanf(&text[at + name.size()], "[%u:%u", &first, &last) < 2) last = first;
        for (unsigned pin = first;; first < last ? ++pin : --pin) {
            pins.push_back(*header_pin(fmt::format("{}[{}]", name, pin)));
            if (pin == last) break;
        }
        at = end + 1;
    }
    return pins;
}

// A list of so many.
Reading read_pins(const YamlNode& node, std::size_t least, std::size_t most) {
    auto pins = read_pin_list(node);
    const std::size_t count = pins ? std::get<Numbers>(*pins).size() : 0;
    return count >= least && count <= most ? pins : std::nullopt;
}

std::string as_json(const std::string& regex) {
    std::string text;
    for (const char c : regex) text += c == '\\' ? "\\\\" : std::string(1, c);
    return fmt::format(R"({{"type": "string", "pattern": "^{}$"}})", text);
}

Reading read_part_name(const YamlNode& node) {
    static const Pattern ALL{NAME};
    if (!is_text(node) || !ALL.matches(node.text)) return std::nullopt;
    return node.text;
}

const ValueType PART_NAME{"a name of letters, digits, - and _", as_json(NAME), read_part_name};

}  // namespace

HeaderPinList pins_of(const Values& values, const std::string& field) {
    HeaderPinList pins;
    for (const std::uint64_t pin : values.list(field)) pins.push_back(static_cast<HeaderPin>(pin));
    return pins;
}

Field part_name() { return {"name", PART_NAME, Need::REQUIRED, "", "By which steps call it."}; }

namespace value_types {

const ValueType PART_PIN{"a pin such as GPIO_0[3], numbered 0 to 35", as_json(ONE_PIN),
                         [](const YamlNode& node) { return read_pins(node, 1, 1); }};
const ValueType PART_PINS{"1 to 32 pins such as GPIO_1[15:8], numbered 0 to 35", as_json(PIN_LIST),
                          [](const YamlNode& node) { return read_pins(node, 1, 32); }};
const ValueType NUMBER_PINS{"1 to 5 pins such as GPIO_1[35:32], numbered 0 to 35",
                            as_json(PIN_LIST),
                            [](const YamlNode& node) { return read_pins(node, 1, 5); }};
const ValueType EIGHT_PINS{"eight pins such as GPIO_1[7:0], numbered 0 to 35", as_json(PIN_LIST),
                           [](const YamlNode& node) { return read_pins(node, 8, 8); }};
const ValueType PIN_LEVEL = word("low or high", {"low", "high"});

}  // namespace value_types

}  // namespace sim
