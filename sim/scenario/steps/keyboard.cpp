// keyboard.cpp - type-keys, press-key, hold-key, release-key: the PS/2 keyboard, or the USB one
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>

#include "sim/board/ps2_keyboard.h"
#include "sim/board/scan_codes.h"
#include "sim/board/usb_keyboard.h"
#include "sim/scenario/board_control.h"
#include "sim/scenario/static_checks.h"
#include "sim/scenario/step_form.h"
#include "sim/text/words.h"

namespace sim {

namespace {

using namespace value_types;

// Carries out `action` with the one or the other.
template <class Action>
std::function<void()> on_keyboard(BoardControl& board, bool usb, Action action) {
    if (usb) return [&on = board.part<UsbKeyboard>("USB keyboard"), action] { action(on); };
    return [&on = board.part<Ps2Keyboard>("PS/2 keyboard"), action] { action(on); };
}

void need_keyboard(const StaticChecks& checks, bool usb) {
    if (usb)
        checks.need(UsbPlug::KEYBOARD);
    else
        checks.need(Ps2Plug::KEYBOARD);
}

const char* place_of(bool usb) { return usb ? " on the USB keyboard" : " on the keyboard"; }

// ---- type-keys ----

Reading read_text_of_keys(const YamlNode& node) {
    if (!std::all_of(node.text.begin(), node.text.end(), [](char c) { return stroke(c); }))
        return std::nullopt;
    return TEXT.read(node);
}

const ValueType KEYS_TEXT{"text of characters that a US keyboard has",
                          R"({"type": "string", "pattern": "^[\\t\\n -~]+$"})", read_text_of_keys};

class TypeKeys : public Action {
public:
    explicit TypeKeys(const Values& v)
        : text_{v.get<std::string>("text")}, usb_{v.find("to") != nullptr} {}

    std::string describe() const override { return "type " + in_quotes(text_) + place_of(usb_); }
    void check(StaticChecks& checks) const override { need_keyboard(checks, usb_); }
    void act(BoardControl& board) const override {
        board.act(on_keyboard(board, usb_, [text = text_](auto& on) { on.type(text); }));
    }

private:
    std::string text_;
    bool usb_;
};

// ---- Keys by their names ----

// A key is read as its index in keys().
Reading read_keyboard_key(const YamlNode& node) {
    std::string name = node.text;
    if (name.size() == 1) name[0] = static_cast<char>(std::tolower(name[0]));
    const auto at = std::find_if(keys().begin(), keys().end(),
                                 [&](const Key& key) { return key.name == name; });
    if (at == keys().end()) return std::nullopt;
    return static_cast<std::uint64_t>(at - keys().begin());
}

const ValueType& key_type() {
    static const ValueType TYPE = [] {
        std::vector<std::string> names, choices;
        for (const Key& key : keys()) {
            names.push_back(key.name);
            choices.push_back(key.name == "\\" ? R"("\\")" : '"' + key.name + '"');
            if (key.name.size() > 1) continue;
            if (std::isdigit(key.name[0])) choices.push_back(key.name);
            if (std::isalpha(key.name[0]))
                choices.push_back(
                    std::string{'"', static_cast<char>(std::toupper(key.name[0])), '"'});
        }
        return ValueType{
            "a key: Left, Esc, F1, Ctrl, RightCtrl, Numpad5 and so on, or the "
            "character that it makes",
            fmt::format(R"({{"enum": [{}]}})", fmt::join(choices, ", ")), read_keyboard_key, "key",
            names};
    }();
    return TYPE;
}

class OnKeys : public Action {
protected:
    explicit OnKeys(const Values& v) : usb_{v.find("to") != nullptr} {
        for (const std::uint64_t place : v.list("key")) keys_.push_back(&keys()[place]);
    }

    std::string names() const {
        std::string all;
        for (const Key* key : keys_) all += (all.empty() ? "" : " and ") + key->name;
        return all + place_of(usb_);
    }
    template <class Check>
    void for_each(StaticChecks& checks, Check check) const {
        need_keyboard(checks, usb_);
        for (const Key* key : keys_) check(name_of(*key));
    }

    void hold(BoardControl& board) const {
        for (const Key* key : keys_)
            board.press(name_of(*key),
                        on_keyboard(board, usb_, [key](auto& on) { on.press(key->code); }));
    }
    void release(BoardControl& board) const {
        for (auto at = keys_.rbegin(); at != keys_.rend(); ++at)
            board.let_go(name_of(**at), on_keyboard(board, usb_, [key = *at](auto& on) {
                             on.release(key->code);
                         }));
    }

private:
    std::string name_of(const Key& key) const { return key.name + place_of(usb_); }

    std::vector<const Key*> keys_;
    bool usb_;
};

class PressKey : public OnKeys {
public:
    explicit PressKey(const Values& v) : OnKeys{v}, time_{v.get<SimTime>("for")} {}

    std::string describe() const override {
        return fmt::format("press {} for {}", names(), to_string(time_));
    }
    SimTime least() const override { return time_; }
    void check(StaticChecks& checks) const override {
        for_each(checks, [&](const std::string& key) { checks.need_free(key); });
    }
    void act(BoardControl& board) const override {
        hold(board);
        board.wait(time_);
        release(board);
    }

private:
    SimTime time_;
};

class HoldKey : public OnKeys {
public:
    explicit HoldKey(const Values& v) : OnKeys{v} {}

    std::string describe() const override { return "hold " + names(); }
    void check(StaticChecks& checks) const override {
        for_each(checks, [&](const std::string& key) { checks.hold(key); });
    }
    void act(BoardControl& board) const override { hold(board); }
};

class ReleaseKey : public OnKeys {
public:
    explicit ReleaseKey(const Values& v) : OnKeys{v} {}

    std::string describe() const override { return "release " + names(); }
    void check(StaticChecks& checks) const override {
        for_each(checks, [&](const std::string& key) { checks.release(key); });
    }
    void act(BoardControl& board) const override { release(board); }
};

}  // namespace

namespace steps {

std::vector<StepForm> keyboard() {
    const Field key{
        "key", key_type(), Need::REQUIRED, "",
        "A key by the character that it makes without Shift, or Esc, F1 to F12, "
        "PrintScreen, ScrollLock, Pause, Backspace, Tab, Enter, Space, CapsLock, Shift, "
        "RightShift, Ctrl, RightCtrl, Alt, RightAlt, Win, RightWin, Menu, Insert, Home, "
        "PageUp, Delete, End, PageDown, Up, Left, Down, Right, NumLock, Numpad0 to "
        "Numpad9, NumpadEnter, NumpadPlus, NumpadMinus, NumpadStar, NumpadSlash, "
        "NumpadPoint; or a list: down in this order, up in the other."};
    const Field to{"to", TO_USB, Need::OPTIONAL, "",
                   "usb: on a Linux program's USB keyboard alone, /dev/input/event0. Without it on "
                   "the PS/2 keyboard, which such a program has on USB, too."};
    return {
        {"type-keys",
         "Type a text on the keyboard and go on; a key takes 40 ms.",
         Notation::BOTH,
         {},
         {{"text", KEYS_TEXT, Need::REQUIRED, "", "The text."}, to},
         make<TypeKeys>},
        {"press-key",
         "Hold keys of the keyboard for a while and let go; the next step comes after that. "
         "From 500 ms on the last repeats. A key that was let go of just before is pressed 50 ms "
         "later.",
         Notation::BOTH,
         {},
         {key, {"for", SOME_TIME, Need::OPTIONAL, "100ms", "How long."}, to},
         make<PressKey>},
        {"hold-key",
         "Begin to hold keys of the keyboard and go on to the next step.",
         Notation::BOTH,
         {},
         {key, to},
         make<HoldKey>},
        {"release-key",
         "Let go of keys of the keyboard that are held.",
         Notation::BOTH,
         {},
         {key, to},
         make<ReleaseKey>},
    };
}

}  // namespace steps

}  // namespace sim
