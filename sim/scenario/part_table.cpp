#include "sim/scenario/part_table.h"

#include <cstdio>
#include <map>

#include <fmt/format.h>

#include "sim/board/lt24.h"
#include "sim/text/pattern.h"
#include "sim/text/words.h"

namespace sim {

namespace {

using namespace value_types;
using Kind = PartPlan::Kind;

const std::string NUMBER = "([0-9]|[12][0-9]|3[0-5])";
const std::string ONE_PIN = "GPIO_[01]\\[" + NUMBER + "\\]";
const std::string PIN_RANGE = "GPIO_[01]\\[" + NUMBER + "(:" + NUMBER + ")?\\]";
const std::string PIN_LIST = PIN_RANGE + "(, *" + PIN_RANGE + ")*";
const std::string NAME = "[A-Za-z][A-Za-z0-9_-]*";

// ---- Pins ----

// "GPIO_1[15:8], GPIO_0[3]", from the left.
Reading read_pin_list(const YamlNode& node) {
    static const Pattern LIST{PIN_LIST};
    if (!is_text(node) || !LIST.matches(node.text)) return std::nullopt;
    Numbers pins;
    for (std::size_t at = 0; (at = node.text.find("GPIO", at)) != std::string::npos; ++at) {
        unsigned header = 0, first = 0, last = 0;
        if (std::sscanf(&node.text[at], "GPIO_%u[%u:%u", &header, &first, &last) < 3) last = first;
        for (unsigned pin = first;; first < last ? ++pin : --pin) {
            pins.push_back(header * PINS_OF_A_HEADER + pin);
            if (pin == last) break;
        }
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

const ValueType PART_PIN{"a pin such as GPIO_0[3], numbered 0 to 35", as_json(ONE_PIN),
                         [](const YamlNode& node) { return read_pins(node, 1, 1); }};
const ValueType PART_PINS{"1 to 32 pins such as GPIO_1[15:8], numbered 0 to 35", as_json(PIN_LIST),
                          [](const YamlNode& node) { return read_pins(node, 1, 32); }};
const ValueType NUMBER_PINS{"1 to 5 pins such as GPIO_1[35:32], numbered 0 to 35",
                            as_json(PIN_LIST),
                            [](const YamlNode& node) { return read_pins(node, 1, 5); }};
const ValueType EIGHT_PINS{"eight pins such as GPIO_1[7:0], numbered 0 to 35", as_json(PIN_LIST),
                           [](const YamlNode& node) { return read_pins(node, 8, 8); }};

// ---- Other values ----

Reading read_part_name(const YamlNode& node) {
    static const Pattern ALL{NAME};
    if (!is_text(node) || !ALL.matches(node.text)) return std::nullopt;
    return node.text;
}

const ValueType PART_NAME{"a name of letters, digits, - and _", as_json(NAME), read_part_name};
const ValueType LEVEL_THAT = word("low or high", {"low", "high"});

// ---- The parts ----

PartPlan plan(Kind kind, std::string name, const Values& v, const char* pins = "pin") {
    PartPlan part;
    part.kind = kind;
    part.name = std::move(name);
    part.line = v.line();
    for (const std::uint64_t pin : v.list(pins)) part.pins.push_back(static_cast<HeaderPin>(pin));
    return part;
}

PartPlan button(const Values& v) {
    PartPlan part = plan(Kind::BUTTON, v.get<std::string>("name"), v);
    part.high = v.number<bool>("pressed");
    return part;
}

PartPlan a_switch(const Values& v) { return plan(Kind::SWITCH, v.get<std::string>("name"), v); }

PartPlan led(const Values& v) {
    PartPlan part = plan(Kind::LED, v.get<std::string>("name"), v);
    part.high = v.number<bool>("lit");
    return part;
}

PartPlan led_matrix(const Values& v) {
    const bool coded = v.find("row-number");
    PartPlan part =
        plan(Kind::LED_MATRIX, v.get<std::string>("name"), v, coded ? "row-number" : "rows");
    part.coded_rows = coded;
    for (const std::uint64_t pin : v.list("columns"))
        part.columns.push_back(static_cast<HeaderPin>(pin));
    part.high = v.number<bool>("row-lit");
    part.column_high = v.number<bool>("column-lit");
    return part;
}

PartPlan keypad(const Values& v) { return plan(Kind::KEYPAD, "keypad", v, "pins"); }

const ValueType HEADER = word("GPIO_0 or GPIO_1", {"GPIO_0", "GPIO_1"});

const ValueType BAUD = whole_number("bits per second, 50 to 12500000", 50, 12'500'000);

PartPlan terminal(const Values& v) {
    PartPlan part = plan(Kind::TERMINAL, v.get<std::string>("name"), v, "rx");
    part.pins.push_back(static_cast<HeaderPin>(v.list("tx").front()));
    part.baud = v.number<unsigned>("baud");
    return part;
}

PartPlan lt24(const Values& v) {
    PartPlan part;
    part.kind = Kind::LT24;
    part.name = "lt24";
    part.line = v.line();
    part.pins = Lt24::pins(v.number<unsigned>("header"));
    return part;
}

// The colours of one LED board, which has one decoder.
bool shares_row_number(const PartPlan& part, const PartPlan& other) {
    return &part != &other && part.coded_rows && other.coded_rows && part.pins == other.pins;
}

constexpr const char* NAME_HELP = "By which steps call it.";

}  // namespace

const std::vector<PartForm>& part_forms() {
    static const std::vector<PartForm> FORMS = {
        {"button",
         "A push button. Its contact does not bounce.",
         Notation::MAP,
         {},
         {{"name", PART_NAME, Need::REQUIRED, "", NAME_HELP},
          {"pin", PART_PIN, Need::REQUIRED, "", "Where it is."},
          {"pressed", LEVEL_THAT, Need::OPTIONAL, "low",
           "The level while it is pressed. low: else the pull-up makes it high; high: else a "
           "resistor makes it low."}},
         button},
        {"switch",
         "A slide switch between ground and 3.3 V, which begins low.",
         Notation::MAP,
         {},
         {{"name", PART_NAME, Need::REQUIRED, "", NAME_HELP},
          {"pin", PART_PIN, Need::REQUIRED, "", "Where it is."}},
         a_switch},
        {"led",
         "An LED.",
         Notation::MAP,
         {},
         {{"name", PART_NAME, Need::REQUIRED, "", NAME_HELP},
          {"pin", PART_PIN, Need::REQUIRED, "", "Where it is."},
          {"lit", LEVEL_THAT, Need::OPTIONAL, "high", "The level that lights it."}},
         led},
        {"led-matrix",
         "An LED at each crossing of a row and a column, seen as a person sees it while its rows "
         "or "
         "columns are shown one after the other.",
         Notation::MAP,
         {"rows", "row-number"},
         {{"name", PART_NAME, Need::REQUIRED, "", NAME_HELP},
          {"rows", PART_PINS, Need::OPTIONAL, "", "The rows' pins, from the top."},
          {"row-number", NUMBER_PINS, Need::OPTIONAL, "",
           "Instead of `rows`, where the LED board decodes a number: its pins, from the highest "
           "bit. Row 0 is at the top. Several matrices may share them."},
          {"columns", PART_PINS, Need::REQUIRED, "", "The columns' pins, from the left."},
          {"row-lit", LEVEL_THAT, Need::OPTIONAL, "high", "The level of a row that is shown."},
          {"column-lit", LEVEL_THAT, Need::OPTIONAL, "low",
           "The level of a column whose LED in that row is lit."}},
         led_matrix,
         true},
        {"keypad",
         "The keypad, on other pins than JP1 D7 to D0.",
         Notation::BOTH,
         {},
         {{"pins", EIGHT_PINS, Need::REQUIRED, "",
           "Its columns from the left and its rows from the top: D7 to D0."}},
         keypad},
        {"lt24",
         "Terasic's LT24 display, of which expect-frame and take-screenshot have the picture.",
         Notation::BOTH,
         {},
         {{"header", HEADER, Need::REQUIRED, "", "The header that it is plugged into."}},
         lt24},
        {"terminal",
         "A serial terminal: 8 data bits, no parity, one stop bit. `type-serial` with `to` types "
         "at it, `wait-serial` with `on` reads it.",
         Notation::MAP,
         {},
         {{"name", PART_NAME, Need::REQUIRED, "", NAME_HELP},
          {"rx", PART_PIN, Need::REQUIRED, "", "The pin that it hears: the FPGA's output."},
          {"tx", PART_PIN, Need::REQUIRED, "", "The pin that it drives: the FPGA's input."},
          {"baud", BAUD, Need::OPTIONAL, "115200", "Bits per second."}},
         terminal},
    };
    return FORMS;
}

void check_parts(const std::vector<PartPlan>& parts) {
    std::map<std::string, int> names;
    std::map<HeaderPin, const PartPlan*> pins;
    const auto refuse = [](const PartPlan& part, const std::string& expected,
                           const std::string& got) {
        throw Refusal{part.line, part.column, "expected " + expected + ", got " + got};
    };
    for (const PartPlan& part : parts) {
        const auto [name, is_new] = names.emplace(part.name, part.line);
        if (!is_new)
            refuse(part, "a new name for each part",
                   fmt::format("{} again, first in line {}", in_quotes(part.name), name->second));
        for (const auto* list : {&part.pins, &part.columns})
            for (const HeaderPin pin : *list) {
                const auto [other, is_free] = pins.emplace(pin, &part);
                if (is_free || (list == &part.pins && shares_row_number(part, *other->second)))
                    continue;
                refuse(part, "pins that are free",
                       other->second == &part
                           ? pin_name(pin) + " twice"
                           : fmt::format("{}, which {} of line {} has", pin_name(pin),
                                         other->second->name, other->second->line));
            }
    }
}

const char* kind_name(Kind kind) {
    switch (kind) {
        case Kind::BUTTON: return "a button";
        case Kind::SWITCH: return "a switch";
        case Kind::LED: return "an led";
        case Kind::LED_MATRIX: return "an led-matrix";
        case Kind::KEYPAD: return "a keypad";
        case Kind::LT24: return "an lt24";
        case Kind::TERMINAL: return "a terminal";
    }
    return "a part";
}

}  // namespace sim
