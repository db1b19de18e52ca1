// controls.cpp - delay, press, hold, release: the board's controls, and waiting
#include <fmt/format.h>

#include "sim/scenario/board_control.h"
#include "sim/scenario/controls.h"
#include "sim/scenario/static_checks.h"
#include "sim/scenario/step_form.h"

namespace sim {

namespace {

using namespace value_types;

class Delay : public Action {
public:
    explicit Delay(const Values& v) : time_{v.get<SimTime>("time")} {}

    std::string describe() const override { return "wait " + to_string(time_); }
    SimTime least() const override { return time_; }
    void act(BoardControl& board) const override { board.wait(time_); }

private:
    SimTime time_;
};

class OnControls : public Action {
protected:
    explicit OnControls(const Values& v)
        : controls_{v.mask<std::uint16_t>("keypad"), v.mask<std::uint8_t>("key"),
                    v.mask<std::uint32_t>("switch")},
          bounce_{v.get<SimTime>("bounce")} {}

    template <class Check>
    void for_each(const StaticChecks& checks, Check check) const {
        for (const unsigned number : control_numbers(controls_)) {
            checks.need_on_board(control_wire(number), control_name(number));
            check(control_name(number));
        }
    }

    Controls controls_;
    SimTime bounce_;
};

class Press : public OnControls {
public:
    explicit Press(const Values& v) : OnControls{v}, time_{v.get<SimTime>("for")} {}

    std::string describe() const override {
        return fmt::format("press {} for {}", to_string(controls_), to_string(time_));
    }
    SimTime least() const override { return time_; }
    void check(StaticChecks& checks) const override {
        for_each(checks, [&](const std::string& control) { checks.need_free(control); });
    }
    void act(BoardControl& board) const override {
        board.hold(controls_, bounce_);
        board.wait(time_);
        board.release(controls_, bounce_);
    }

private:
    SimTime time_;
};

class Hold : public OnControls {
public:
    explicit Hold(const Values& v) : OnControls{v} {}
    std::string describe() const override { return "hold " + to_string(controls_); }
    void check(StaticChecks& checks) const override {
        for_each(checks, [&](const std::string& control) { checks.hold(control); });
    }
    void act(BoardControl& board) const override { board.hold(controls_, bounce_); }
};

class Release : public OnControls {
public:
    explicit Release(const Values& v) : OnControls{v} {}

    std::string describe() const override { return "release " + to_string(controls_); }
    void check(StaticChecks& checks) const override {
        for_each(checks, [&](const std::string& control) { checks.release(control); });
    }
    void act(BoardControl& board) const override { board.release(controls_, bounce_); }
};

Reading read_keypad(const YamlNode& node) {
    const auto key = node.text.size() == 1 ? keypad_key(node.text[0]) : std::nullopt;
    if (!key) return std::nullopt;
    return std::uint64_t{*key};
}

Reading read_key(const YamlNode& node) {
    if (node.text == "hps") return std::uint64_t{HPS_KEY};
    return whole_number("", 0, HPS_KEY - 1).read(node);
}

const ValueType KEYPAD{
    "a keypad key, 0-9 or A-F",
    R"({"enum": ["0", "1", "2", "3", "4", "5", "6", "7", "8", "9", "A", "B", "C", "D", "E", "F",
                 0, 1, 2, 3, 4, 5, 6, 7, 8, 9]})",
    read_keypad, "control"};
const ValueType KEY{
    "a key number, 0 to 3, or hps",
    R"({"anyOf": [{"type": "integer", "minimum": 0, "maximum": 3}, {"const": "hps"}]})", read_key,
    "control"};
const ValueType SWITCH = [] {
    ValueType type =
        whole_number(fmt::format("a switch number, 0 to {}", SWITCHES - 1), 0, SWITCHES - 1);
    type.list_of = "control";
    return type;
}();

const std::string SWITCH_HELP =
    fmt::format("Slide switch SW0 to SW{}, or a list of numbers.", SWITCHES - 1);

const std::vector<const char*> ANY_CONTROL = {"keypad", "key", "switch"};

std::vector<Field> controls_and(const std::vector<Field>& others) {
    std::vector<Field> fields = {
        {"keypad", KEYPAD, Need::OPTIONAL, "", "Keypad key, 0-9 or A-F, or a list of them."},
        {"key", KEY, Need::OPTIONAL, "",
         "Push button KEY0 to KEY3 by its number, hps: HPS_KEY, or a list."},
        {"switch", SWITCH, Need::OPTIONAL, "", SWITCH_HELP.c_str()},
        {"bounce", TIME, Need::OPTIONAL, "500us",
         "How long contacts of the switches bounce at most; at time 0 they do not, nor do KEYs."},
    };
    for (const Field& other : others) fields.push_back(other);
    return fields;
}

}  // namespace

namespace steps {

std::vector<StepForm> controls() {
    return {
        {"delay",
         "Let simulated time pass.",
         Notation::BARE,
         {},
         {{"time", TIME, Need::REQUIRED, "", "How long."}},
         make<Delay>},
        {"press",
         "Hold controls for a while and let go; the next step comes after that. If the step just "
         "before let go of one of them, this press begins 50 ms later, as a finger does.",
         Notation::MAP, ANY_CONTROL,
         controls_and({{"for", SOME_TIME, Need::OPTIONAL, "100ms", "How long."}}), make<Press>},
        {"hold",
         "Begin to hold controls and go on to the next step, for chords that overlap in time. One "
         "that was let go of just before is held 50 ms later.",
         Notation::MAP, ANY_CONTROL, controls_and({}), make<Hold>},
        {"release", "Let go of controls that are held.", Notation::MAP, ANY_CONTROL,
         controls_and({}), make<Release>},
    };
}

}  // namespace steps

}  // namespace sim
