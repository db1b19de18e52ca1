// contacts.cpp - the parts button and switch; press-button, hold-button, release-button, set-switch
#include "sim/board/contact.h"

#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "sim/scenario/board_control.h"
#include "sim/scenario/part_form.h"
#include "sim/scenario/static_checks.h"

namespace sim {

namespace {

using namespace value_types;

// ---- The parts ----

PartPlan contact(const Values& v, Contact::Levels levels) {
    PartPlan part;
    part.pins = pins_of(v, "pin");
    part.hang = [pin = part.pins.front(), levels](const PartSocket& socket) {
        return std::make_unique<Contact>(pin, levels, socket);
    };
    return part;
}

PartPlan a_switch(const Values& v) {
    PartPlan part = contact(v, {PinLevel::LOW, PinLevel::HIGH});
    part.control = {[](const std::string& name, bool on) {
                        const nlohmann::json to{{"switch", name}, {"level", on ? "high" : "low"}};
                        return nlohmann::json{{"set-switch", to}}.dump();
                    },
                    true};
    return part;
}

// It closes a wire to ground or to 3.3 V; in the second case a resistor pulls it low else.
PartPlan button(const Values& v) {
    PartPlan part = v.number<bool>("pressed") ? contact(v, {PinLevel::LOW, PinLevel::HIGH})
                                              : contact(v, {PinLevel::RELEASED, PinLevel::LOW});
    part.control = {[](const std::string& name, bool on) {
        return nlohmann::json{{on ? "hold-button" : "release-button", name}}.dump();
    }};
    return part;
}

// ---- Buttons ----

class OnPartButton : public Action {
protected:
    explicit OnPartButton(const Values& v) : button_{v.get<std::string>("button")} {}

    std::string control(const StaticChecks& checks) const {
        checks.need_part("button", button_);
        return "button " + button_;
    }

    void press(BoardControl& board) const {
        board.press(finger(), [&contact = board.part<Contact>(button_)] { contact.close(true); });
    }
    void let_go(BoardControl& board) const {
        board.let_go(finger(), [&contact = board.part<Contact>(button_)] { contact.close(false); });
    }

    std::string button_;

private:
    std::string finger() const { return "part " + button_; }
};

class PressPartButton : public OnPartButton {
public:
    explicit PressPartButton(const Values& v) : OnPartButton{v}, time_{v.get<SimTime>("for")} {}

    std::string describe() const override {
        return fmt::format("press the button {} for {}", button_, to_string(time_));
    }
    SimTime least() const override { return time_; }
    void check(StaticChecks& checks) const override { checks.need_free(control(checks)); }
    void act(BoardControl& board) const override {
        press(board);
        board.wait(time_);
        let_go(board);
    }

private:
    SimTime time_;
};

class HoldPartButton : public OnPartButton {
public:
    explicit HoldPartButton(const Values& v) : OnPartButton{v} {}
    std::string describe() const override { return "hold the button " + button_; }
    void check(StaticChecks& checks) const override { checks.hold(control(checks)); }
    void act(BoardControl& board) const override { press(board); }
};

class ReleasePartButton : public OnPartButton {
public:
    explicit ReleasePartButton(const Values& v) : OnPartButton{v} {}
    std::string describe() const override { return "release the button " + button_; }
    void check(StaticChecks& checks) const override { checks.release(control(checks)); }
    void act(BoardControl& board) const override { let_go(board); }
};

// ---- set-switch ----

class SetSwitch : public Action {
public:
    explicit SetSwitch(const Values& v)
        : switch_{v.get<std::string>("switch")}, high_{v.number<bool>("level")} {}

    std::string describe() const override {
        return fmt::format("set the switch {} {}", switch_, high_ ? "high" : "low");
    }
    void check(StaticChecks& checks) const override { checks.need_part("switch", switch_); }
    void act(BoardControl& board) const override {
        board.act([high = high_, &contact = board.part<Contact>(switch_)] { contact.close(high); });
    }

private:
    std::string switch_;
    bool high_;
};

}  // namespace

namespace parts {

PartFamily contacts() {
    const Field pin{"pin", PART_PIN, Need::REQUIRED, "", "Where it is."};
    std::vector<PartForm> parts{
        {"button",
         "A push button. Its contact does not bounce.",
         Notation::MAP,
         {},
         {part_name(),
          pin,
          {"pressed", PIN_LEVEL, Need::OPTIONAL, "low",
           "The level while it is pressed. low: else the pull-up makes it high; high: else a "
           "resistor makes it low."}},
         button},
        {"switch",
         "A slide switch between ground and 3.3 V, which begins low.",
         Notation::MAP,
         {},
         {part_name(), pin},
         a_switch},
    };
    const Field by_name{"button", LINE, Need::REQUIRED, "", "Its name among the parts."};
    std::vector<StepForm> steps{
        {"press-button",
         "Press a button of the parts and let go; the next step comes after that. One that was "
         "let go of just before is pressed 50 ms later.",
         Notation::BOTH,
         {},
         {by_name, {"for", SOME_TIME, Need::OPTIONAL, "100ms", "How long."}},
         make<PressPartButton>},
        {"hold-button",
         "Begin to hold a button of the parts and go on to the next step.",
         Notation::BOTH,
         {},
         {by_name},
         make<HoldPartButton>},
        {"release-button",
         "Let go of a button that is held.",
         Notation::BOTH,
         {},
         {by_name},
         make<ReleasePartButton>},
        {"set-switch",
         "Move a switch of the parts and go on.",
         Notation::MAP,
         {},
         {{"switch", LINE, Need::REQUIRED, "", "Its name among the parts."},
          {"level", PIN_LEVEL, Need::REQUIRED, "", "What it puts on its pin."}},
         make<SetSwitch>},
    };
    return {std::move(parts), std::move(steps)};
}

}  // namespace parts

}  // namespace sim
