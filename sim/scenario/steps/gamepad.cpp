// gamepad.cpp - press-pad-button, hold-pad-button, release-pad-button, move-stick: USB gamepads
#include <optional>

#include <fmt/format.h>

#include "sim/board/usb_ports.h"
#include "sim/scenario/board_control.h"
#include "sim/scenario/static_checks.h"
#include "sim/scenario/step_form.h"
#include "sim/text/words.h"

namespace sim {

namespace {

using namespace value_types;

std::optional<unsigned> pad_of(const Values& v) {
    return v.find("pad") ? std::optional{v.number<unsigned>("pad")} : std::nullopt;
}

const char* name_of_pad(std::optional<unsigned> pad) {
    return !pad ? "the gamepad" : *pad == 1 ? "the first gamepad" : "the second gamepad";
}

// ---- Buttons ----

struct PadControl {
    const char* name;
    std::optional<UsbGamepad::Direction> direction;  // of the d-pad
    PadButton button{};                              // or a button

    bool is_on(UsbPlug plug) const {
        return direction || UsbGamepad::number_of(button, plug).has_value();
    }
    bool is_down(const UsbGamepad& pad) const {
        return direction ? pad.is_down(*direction) : pad.is_down(button);
    }
    void move(UsbGamepad& pad, bool down) const {
        if (direction)
            pad.direction(*direction, down);
        else
            pad.button(button, down);
    }
};

const std::vector<PadControl>& pad_controls() {
    using Direction = UsbGamepad::Direction;
    static const std::vector<PadControl> ALL{
        {"A", {}, PadButton::A},
        {"B", {}, PadButton::B},
        {"X", {}, PadButton::X},
        {"Y", {}, PadButton::Y},
        {"L", {}, PadButton::L},
        {"R", {}, PadButton::R},
        {"L2", {}, PadButton::L2},
        {"R2", {}, PadButton::R2},
        {"Select", {}, PadButton::SELECT},
        {"Start", {}, PadButton::START},
        {"Home", {}, PadButton::HOME},
        {"LeftStick", {}, PadButton::LEFT_STICK},
        {"RightStick", {}, PadButton::RIGHT_STICK},
        {"Up", Direction::UP},
        {"Down", Direction::DOWN},
        {"Left", Direction::LEFT},
        {"Right", Direction::RIGHT},
    };
    return ALL;
}

std::string names_of_controls(UsbPlug plug) {
    std::vector<std::string> names;
    for (const PadControl& control : pad_controls())
        if (control.is_on(plug)) names.emplace_back(control.name);
    return list_of(names);
}

class OnPadButton : public Action {
protected:
    explicit OnPadButton(const Values& v)
        : control_{pad_controls()[v.number<std::size_t>("button")]}, pad_{pad_of(v)} {}

    std::string name() const { return name_of(pad_); }
    // As hands know it, on that gamepad.
    std::string needed(const StaticChecks& checks) const {
        const UsbPlugged on = checks.need_gamepad(pad_);
        if (!control_.is_on(on.plug))
            checks.refuse_step("a button of a snes-gamepad: " + names_of_controls(on.plug),
                               control_.name);
        return name_of(on.number);
    }
    std::string needed_held(const StaticChecks& checks) const {
        if (pad_) return name();
        const bool first = checks.is_held(name_of(1)), second = checks.is_held(name_of(2));
        if (first && second)
            checks.refuse_step("pad: 1 or pad: 2 in the step, as it is held on two gamepads",
                               "neither");
        return first || second ? name_of(first ? 1 : 2) : name();
    }
    void hold(BoardControl& board) const {
        auto& ports = board.part<UsbPorts>("USB ports");
        const UsbPlugged on = ports.plugged().gamepads(pad_).front();
        board.press(name_of(on.number),
                    [&pad = ports.gamepad(on), control = control_] { control.move(pad, true); });
    }
    void release(BoardControl& board) const {
        auto& ports = board.part<UsbPorts>("USB ports");
        for (unsigned number = 1; number <= UsbPlugs::GAMEPADS; ++number)
            for (const UsbPlug plug : {UsbPlug::GAMEPAD, UsbPlug::SNES_GAMEPAD}) {
                UsbGamepad& pad = ports.gamepad({plug, number});
                if (number != pad_.value_or(number) || !control_.is_down(pad)) continue;
                board.let_go(name_of(number),
                             [&pad, control = control_] { control.move(pad, false); });
            }
    }

private:
    std::string name_of(std::optional<unsigned> pad) const {
        return fmt::format("{} on {}", control_.name, name_of_pad(pad));
    }

    PadControl control_;
    std::optional<unsigned> pad_;
};

class PressPadButton : public OnPadButton {
public:
    explicit PressPadButton(const Values& v) : OnPadButton{v}, time_{v.get<SimTime>("for")} {}

    std::string describe() const override {
        return fmt::format("press {} for {}", name(), to_string(time_));
    }
    SimTime least() const override { return time_; }
    void check(StaticChecks& checks) const override { checks.need_free(needed(checks)); }
    void act(BoardControl& board) const override {
        hold(board);
        board.wait(time_);
        release(board);
    }

private:
    SimTime time_;
};

class HoldPadButton : public OnPadButton {
public:
    explicit HoldPadButton(const Values& v) : OnPadButton{v} {}
    std::string describe() const override { return "hold " + name(); }
    void check(StaticChecks& checks) const override { checks.hold(needed(checks)); }
    void act(BoardControl& board) const override { hold(board); }
};

class ReleasePadButton : public OnPadButton {
public:
    explicit ReleasePadButton(const Values& v) : OnPadButton{v} {}
    std::string describe() const override { return "release " + name(); }
    void check(StaticChecks& checks) const override { checks.release(needed_held(checks)); }
    void act(BoardControl& board) const override { release(board); }
};

// ---- Sticks ----

constexpr const char* STICKS[] = {"left", "right"};  // as UsbGamepad::Stick

class MoveStick : public Action {
public:
    explicit MoveStick(const Values& v)
        : stick_{v.number<UsbGamepad::Stick>("stick")},
          right_{v.number<int>("right")},
          down_{v.number<int>("down")},
          pad_{pad_of(v)} {
        if (v.find("for")) time_ = v.get<SimTime>("for");
    }

    std::string describe() const override {
        return fmt::format("move the {} stick{} to {}% right and {}% down{}",
                           STICKS[static_cast<std::size_t>(stick_)],
                           pad_ ? std::string{" of "} + name_of_pad(pad_) : "", right_, down_,
                           time_ ? " for " + to_string(*time_) : "");
    }
    SimTime least() const override { return time_.value_or(SimTime{}); }
    void check(StaticChecks& checks) const override {
        if (checks.need_gamepad(pad_).plug == UsbPlug::SNES_GAMEPAD)
            checks.refuse_step("a gamepad with sticks", "a snes-gamepad, which has none");
    }
    void act(BoardControl& board) const override {
        auto& ports = board.part<UsbPorts>("USB ports");
        UsbGamepad& pad = ports.gamepad(ports.plugged().gamepads(pad_).front());
        move(board, pad, right_, down_);
        if (!time_) return;
        board.wait(*time_);
        move(board, pad, 0, 0);
    }

private:
    void move(BoardControl& board, UsbGamepad& pad, int right, int down) const {
        board.act([&pad, stick = stick_, right, down] { pad.stick(stick, right, down); });
    }

    UsbGamepad::Stick stick_;
    int right_, down_;
    std::optional<unsigned> pad_;
    std::optional<SimTime> time_;
};

const ValueType& pad_button() {
    static const ValueType TYPE = [] {
        std::vector<std::string> names;
        for (const PadControl& control : pad_controls()) names.emplace_back(control.name);
        return word("a button of a gamepad: A, Start, Up and so on", names);
    }();
    return TYPE;
}

const ValueType STICK = word("left or right", {std::begin(STICKS), std::end(STICKS)});
const ValueType REACH = signed_number("a percentage from -100 to 100", UsbGamepad::REACH);

}  // namespace

namespace steps {

std::vector<StepForm> gamepad() {
    const Field button{
        "button", pad_button(), Need::REQUIRED, "",
        "A, B, X, Y, L, R, L2, R2, Select, Start, Home, LeftStick or RightStick; Up, "
        "Down, Left or Right of the d-pad. A snes-gamepad has no L2, R2, Home and sticks."};
    const Field pad{
        "pad", PAD, Need::OPTIONAL, "",
        "Which gamepad, where two are plugged in: 1 is the first of usb, 2 the second."};
    return {
        {"press-pad-button",
         "Hold a button of a USB gamepad for a while and let go; the next step comes after that. "
         "A Linux program has it as /dev/input/js0 and an event device, if the scenario's usb has "
         "it or plug-usb was before. A button that was let go of just before is pressed 50 ms "
         "later.",
         Notation::BOTH,
         {},
         {button, {"for", SOME_TIME, Need::OPTIONAL, "100ms", "How long."}, pad},
         make<PressPadButton>},
        {"hold-pad-button",
         "Begin to hold a button of a USB gamepad and go on to the next step.",
         Notation::BOTH,
         {},
         {button, pad},
         make<HoldPadButton>},
        {"release-pad-button",
         "Let go of a button of a USB gamepad that is held.",
         Notation::BOTH,
         {},
         {button, pad},
         make<ReleasePadButton>},
        {"move-stick",
         "Move a stick of a USB gamepad at once; it stays there.",
         Notation::MAP,
         {},
         {{"stick", STICK, Need::REQUIRED, "", "left or right."},
          {"right", REACH, Need::OPTIONAL, "",
           "In percent of its reach. Less than 0 is to the left; without it 0, the middle."},
          {"down", REACH, Need::OPTIONAL, "", "Likewise; less than 0 is up."},
          {"for", SOME_TIME, Need::OPTIONAL, "",
           "After this time it springs back to the middle, and the next step comes."},
          pad},
         make<MoveStick>},
    };
}

}  // namespace steps

}  // namespace sim
