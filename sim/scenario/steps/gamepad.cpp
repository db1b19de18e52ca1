// gamepad.cpp - press-pad-button, hold-pad-button, release-pad-button, move-stick: the USB gamepad
#include <optional>

#include <fmt/format.h>

#include "sim/board/usb_gamepad.h"
#include "sim/scenario/board_control.h"
#include "sim/scenario/static_checks.h"
#include "sim/scenario/step_form.h"

namespace sim {

namespace {

using namespace value_types;

UsbGamepad& gamepad(BoardControl& board) { return board.part<UsbGamepad>("USB gamepad"); }

// ---- Buttons ----

struct PadButton {
    const char* name;
    std::optional<UsbGamepad::Direction> direction;  // of the d-pad
    unsigned number = 0;                             // of a button
};

const std::vector<PadButton>& pad_buttons() {
    using Direction = UsbGamepad::Direction;
    static const std::vector<PadButton> ALL{
        {"A", {}, 0},
        {"B", {}, 1},
        {"X", {}, 3},
        {"Y", {}, 4},
        {"L", {}, 6},
        {"R", {}, 7},
        {"L2", {}, 8},
        {"R2", {}, 9},
        {"Select", {}, 10},
        {"Start", {}, 11},
        {"Home", {}, 12},
        {"LeftStick", {}, 13},
        {"RightStick", {}, 14},
        {"Up", Direction::UP},
        {"Down", Direction::DOWN},
        {"Left", Direction::LEFT},
        {"Right", Direction::RIGHT},
    };
    return ALL;
}

void move_button(UsbGamepad& pad, const PadButton& button, bool down) {
    if (button.direction)
        pad.direction(*button.direction, down);
    else
        pad.button(button.number, down);
}

class OnPadButton : public Action {
protected:
    explicit OnPadButton(const Values& v)
        : button_{pad_buttons()[v.number<std::size_t>("button")]} {}

    std::string name() const { return fmt::format("{} on the gamepad", button_.name); }
    std::string needed(const StaticChecks& checks) const {
        checks.need(UsbPlug::GAMEPAD);
        return name();
    }
    void hold(BoardControl& board) const {
        board.press(name(),
                    [&on = gamepad(board), button = button_] { move_button(on, button, true); });
    }
    void release(BoardControl& board) const {
        board.let_go(name(),
                     [&on = gamepad(board), button = button_] { move_button(on, button, false); });
    }

private:
    PadButton button_;
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
    void check(StaticChecks& checks) const override { checks.release(name()); }
    void act(BoardControl& board) const override { release(board); }
};

// ---- Sticks ----

constexpr const char* STICKS[] = {"left", "right"};  // as UsbGamepad::Stick

class MoveStick : public Action {
public:
    explicit MoveStick(const Values& v)
        : stick_{v.number<UsbGamepad::Stick>("stick")},
          right_{v.number<int>("right")},
          down_{v.number<int>("down")} {
        if (v.find("for")) time_ = v.get<SimTime>("for");
    }

    std::string describe() const override {
        return fmt::format("move the {} stick to {}% right and {}% down{}",
                           STICKS[static_cast<std::size_t>(stick_)], right_, down_,
                           time_ ? " for " + to_string(*time_) : "");
    }
    SimTime least() const override { return time_.value_or(SimTime{}); }
    void check(StaticChecks& checks) const override { checks.need(UsbPlug::GAMEPAD); }
    void act(BoardControl& board) const override {
        move(board, right_, down_);
        if (!time_) return;
        board.wait(*time_);
        move(board, 0, 0);
    }

private:
    void move(BoardControl& board, int right, int down) const {
        board.act([&pad = gamepad(board), stick = stick_, right, down] {
            pad.stick(stick, right, down);
        });
    }

    UsbGamepad::Stick stick_;
    int right_, down_;
    std::optional<SimTime> time_;
};

const ValueType& pad_button() {
    static const ValueType TYPE = [] {
        std::vector<std::string> names;
        for (const PadButton& button : pad_buttons()) names.emplace_back(button.name);
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
        "Down, Left or Right of the d-pad."};
    return {
        {"press-pad-button",
         "Hold a button of the USB gamepad for a while and let go; the next step comes after that. "
         "A Linux program has it as /dev/input/js0 and an event device, if the scenario's usb has "
         "it or plug-usb was before. A button that was let go of just before is pressed 50 ms "
         "later.",
         Notation::BOTH,
         {},
         {button, {"for", SOME_TIME, Need::OPTIONAL, "100ms", "How long."}},
         make<PressPadButton>},
        {"hold-pad-button",
         "Begin to hold a button of the USB gamepad and go on to the next step.",
         Notation::BOTH,
         {},
         {button},
         make<HoldPadButton>},
        {"release-pad-button",
         "Let go of a button of the USB gamepad that is held.",
         Notation::BOTH,
         {},
         {button},
         make<ReleasePadButton>},
        {"move-stick",
         "Move a stick of the USB gamepad at once; it stays there.",
         Notation::MAP,
         {},
         {{"stick", STICK, Need::REQUIRED, "", "left or right."},
          {"right", REACH, Need::OPTIONAL, "",
           "In percent of its reach. Less than 0 is to the left; without it 0, the middle."},
          {"down", REACH, Need::OPTIONAL, "", "Likewise; less than 0 is up."},
          {"for", SOME_TIME, Need::OPTIONAL, "",
           "After this time it springs back to the middle, and the next step comes."}},
         make<MoveStick>},
    };
}

}  // namespace steps

}  // namespace sim
