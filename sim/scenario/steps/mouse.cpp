// mouse.cpp - move-mouse, click-mouse, hold-mouse, release-mouse, drag-mouse, turn-wheel
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "sim/board/ps2_mouse.h"
#include "sim/board/usb_mouse.h"
#include "sim/scenario/board_control.h"
#include "sim/scenario/static_checks.h"
#include "sim/scenario/step_form.h"

namespace sim {

namespace {

using namespace value_types;

constexpr const char* BUTTONS[] = {"left", "right", "middle"};  // as MouseButton

// The PS/2 mouse, or the USB one.
class WhichMouse {
public:
    explicit WhichMouse(const Values& v) : usb_{v.find("to") != nullptr} {}

    std::string name() const { return usb_ ? "the USB mouse" : "the mouse"; }
    std::string name_of(MouseButton button) const {
        return fmt::format("the {} {}mouse button", BUTTONS[static_cast<std::size_t>(button)],
                           usb_ ? "USB " : "");
    }
    void need(const StaticChecks& checks) const {
        if (usb_)
            checks.need(UsbPlug::MOUSE);
        else
            checks.need(Ps2Plug::MOUSE);
    }
    // Carries out `action` with it.
    template <class Action>
    std::function<void()> doing(BoardControl& board, Action action) const {
        if (usb_) return [&on = board.part<UsbMouse>("USB mouse"), action] { action(on); };
        return [&on = board.part<Ps2Mouse>("PS/2 mouse"), action] { action(on); };
    }

private:
    bool usb_;
};

// ---- Parts of the steps ----

// A movement of the mouse, at constant speed.
class Way {
public:
    explicit Way(const Values& v)
        : right_{v.number<int>("right")},
          down_{v.number<int>("down")},
          time_{v.get<SimTime>("for")},
          mouse_{v} {}

    std::string describe() const {
        return fmt::format("{} {} to the right and {} down in {}", mouse_.name(), right_, down_,
                           to_string(time_));
    }
    SimTime time() const { return time_; }
    void go(BoardControl& board) const {
        constexpr std::uint64_t PIECE_PS = 1'000'000'000;  // 1 ms
        int gone_right = 0, gone_down = 0;
        for (std::uint64_t now = 0; now < time_.ps;) {
            const std::uint64_t next = std::min(now + PIECE_PS, time_.ps);
            board.wait(SimTime{next - now});
            now = next;
            const double share = static_cast<double>(now) / static_cast<double>(time_.ps);
            const int right = static_cast<int>(right_ * share),
                      down = static_cast<int>(down_ * share);
            if (right != gone_right || down != gone_down)
                board.act(mouse_.doing(
                    board, [more_right = right - gone_right, more_up = gone_down - down](
                               auto& moved) { moved.move(more_right, more_up); }));
            gone_right = right;
            gone_down = down;
        }
    }

private:
    int right_, down_;
    SimTime time_;
    WhichMouse mouse_;
};

class OnButton : public Action {
protected:
    explicit OnButton(const Values& v) : button_{v.number<MouseButton>("button")}, mouse_{v} {}

    void check(StaticChecks& checks) const override {
        mouse_.need(checks);
        check_button(checks, name());
    }
    virtual void check_button(StaticChecks& checks, const std::string& name) const {
        checks.need_free(name);
    }

    void hold(BoardControl& board) const {
        board.press(name(),
                    mouse_.doing(board, [button = button_](auto& on) { on.button(button, true); }));
    }
    void release(BoardControl& board) const {
        board.let_go(name(), mouse_.doing(board, [button = button_](auto& on) {
            on.button(button, false);
        }));
    }

    std::string name() const { return mouse_.name_of(button_); }

    MouseButton button_;
    WhichMouse mouse_;
};

// ---- The steps ----

class MoveMouse : public Action {
public:
    explicit MoveMouse(const Values& v) : way_{v}, mouse_{v} {}

    std::string describe() const override { return "move " + way_.describe(); }
    SimTime least() const override { return way_.time(); }
    void check(StaticChecks& checks) const override { mouse_.need(checks); }
    void act(BoardControl& board) const override { way_.go(board); }

private:
    Way way_;
    WhichMouse mouse_;
};

class ClickMouse : public OnButton {
public:
    explicit ClickMouse(const Values& v) : OnButton{v}, time_{v.get<SimTime>("for")} {}

    std::string describe() const override {
        return fmt::format("press {} for {}", name(), to_string(time_));
    }
    SimTime least() const override { return time_; }
    void act(BoardControl& board) const override {
        hold(board);
        board.wait(time_);
        release(board);
    }

private:
    SimTime time_;
};

class HoldMouse : public OnButton {
public:
    explicit HoldMouse(const Values& v) : OnButton{v} {}

    std::string describe() const override { return "hold " + name(); }
    void check_button(StaticChecks& checks, const std::string& name) const override {
        checks.hold(name);
    }
    void act(BoardControl& board) const override { hold(board); }
};

class ReleaseMouse : public OnButton {
public:
    explicit ReleaseMouse(const Values& v) : OnButton{v} {}

    std::string describe() const override { return "release " + name(); }
    void check_button(StaticChecks& checks, const std::string& name) const override {
        checks.release(name);
    }
    void act(BoardControl& board) const override { release(board); }
};

class DragMouse : public OnButton {
public:
    explicit DragMouse(const Values& v) : OnButton{v}, way_{v} {}

    std::string describe() const override {
        return fmt::format("drag {} with {}", way_.describe(), name());
    }
    SimTime least() const override { return {way_.time().ps + 2 * STILL.ps}; }
    void act(BoardControl& board) const override {
        hold(board);
        board.wait(STILL);
        way_.go(board);
        board.wait(STILL);
        release(board);
    }

private:
    // Long enough for a packet at every rate from 40 per second on.
    static constexpr SimTime STILL{30'000'000'000};

    Way way_;
};

class TurnWheel : public Action {
public:
    explicit TurnWheel(const Values& v) : notches_{v.number<int>("notches")}, mouse_{v} {}

    std::string describe() const override {
        return fmt::format("turn {} wheel by {} {}", mouse_.name(), std::abs(notches_),
                           notches_ < 0 ? "away from the hand" : "towards the hand");
    }
    void check(StaticChecks& checks) const override { mouse_.need(checks); }
    void act(BoardControl& board) const override {
        board.act(
            mouse_.doing(board, [notches = notches_](auto& turned) { turned.turn(notches); }));
    }

private:
    int notches_;
    WhichMouse mouse_;
};

const ValueType DISTANCE = signed_number("a distance from -5000 to 5000", 5000);
const ValueType NOTCHES = signed_number("a number of notches from -8 to 8", 8);
const ValueType BUTTON = word("left, right or middle", {std::begin(BUTTONS), std::end(BUTTONS)});

const Field TO{"to", TO_USB, Need::OPTIONAL, "",
               "usb: a Linux program's USB mouse alone, /dev/input/mice and event1. Without it the "
               "PS/2 mouse, which such a program has on USB, too."};

std::vector<Field> way_and(const std::vector<Field>& others) {
    std::vector<Field> fields = others;
    for (const Field& field : std::vector<Field>{
             {"right", DISTANCE, Need::OPTIONAL, "",
              "In quarters of a millimetre: counts, unless the program sets another resolution. "
              "Less than 0 is to the left; without it 0."},
             {"down", DISTANCE, Need::OPTIONAL, "", "Likewise; less than 0 is up."},
             {"for", SOME_TIME, Need::OPTIONAL, "100ms", "How long the way takes."},
             TO})
        fields.push_back(field);
    return fields;
}

}  // namespace

namespace steps {

std::vector<StepForm> mouse() {
    const std::vector<const char*> any_way = {"right", "down"};
    const Field button{"button", BUTTON, Need::REQUIRED, "", "left, right or middle."};
    const Field left{"button", BUTTON, Need::OPTIONAL, "left", "left, right or middle."};
    return {
        {"move-mouse", "Move the mouse; the next step comes when it has arrived.", Notation::MAP,
         any_way, way_and({}), make<MoveMouse>},
        {"click-mouse",
         "Hold a button of the mouse for a while and let go. Two clicks of one button are 50 "
         "ms apart.",
         Notation::BOTH,
         {},
         {button, {"for", SOME_TIME, Need::OPTIONAL, "100ms", "How long."}, TO},
         make<ClickMouse>},
        {"hold-mouse",
         "Begin to hold a button of the mouse and go on to the next step.",
         Notation::BOTH,
         {},
         {button, TO},
         make<HoldMouse>},
        {"release-mouse",
         "Let go of a button of the mouse that is held.",
         Notation::BOTH,
         {},
         {button, TO},
         make<ReleaseMouse>},
        {"drag-mouse", "Move the mouse with a button held, 30 ms longer at each end.",
         Notation::MAP, any_way, way_and({left}), make<DragMouse>},
        {"turn-wheel",
         "Turn the wheel of the mouse at once and go on.",
         Notation::BOTH,
         {},
         {{"notches", NOTCHES, Need::REQUIRED, "",
           "Towards the hand, as for going down in a text; less than 0 is away from it."},
          TO},
         make<TurnWheel>},
    };
}

}  // namespace steps

}  // namespace sim
