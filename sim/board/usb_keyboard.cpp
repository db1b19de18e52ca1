#include "sim/board/usb_keyboard.h"

#include <algorithm>

namespace sim {

namespace {

constexpr std::uint8_t FIRST_MODIFIER = 0xE0;

const UsbBytes KEYBOARD_REPORT{
    0x05, 0x01, 0x09, 0x06, 0xA1, 0x01,                          // a keyboard
    0x05, 0x07, 0x19, 0xE0, 0x29, 0xE7, 0x15, 0x00, 0x25, 0x01,  // keys E0 to E7: a bit each
    0x75, 0x01, 0x95, 0x08, 0x81, 0x02, 0x95, 0x01, 0x75, 0x08, 0x81, 0x01,  // and an unused byte
    0x95, 0x03, 0x75, 0x01, 0x05, 0x08, 0x19, 0x01, 0x29, 0x03, 0x91, 0x02,  // three lamps
    0x95, 0x01, 0x75, 0x05, 0x91, 0x01,                                      // and 5 unused bits
    0x95, 0x06, 0x75, 0x08, 0x15, 0x00, 0x25, 0x65,                          // six keys,
    0x05, 0x07, 0x19, 0x00, 0x29, 0x65, 0x81, 0x00, 0xC0,                    // a byte each
};

// Usages, by the names of the keys, in rows of consecutive numbers.
struct UsageRow {
    std::uint8_t first;
    std::vector<std::string> names;
};

const std::vector<UsageRow>& usage_rows() {
    static const std::vector<UsageRow> rows{
        {0x04, {"a",     "b",   "c",         "d",   "e",     "f", "g", "h", "i", "j", "k", "l",
                "m",     "n",   "o",         "p",   "q",     "r", "s", "t", "u", "v", "w", "x",
                "y",     "z",   "1",         "2",   "3",     "4", "5", "6", "7", "8", "9", "0",
                "Enter", "Esc", "Backspace", "Tab", "Space", "-", "=", "[", "]", "\\"}},
        {0x33,
         {";",          "'",           "`",          ",",           ".",          "/",
          "CapsLock",   "F1",          "F2",         "F3",          "F4",         "F5",
          "F6",         "F7",          "F8",         "F9",          "F10",        "F11",
          "F12",        "PrintScreen", "ScrollLock", "Pause",       "Insert",     "Home",
          "PageUp",     "Delete",      "End",        "PageDown",    "Right",      "Left",
          "Down",       "Up",          "NumLock",    "NumpadSlash", "NumpadStar", "NumpadMinus",
          "NumpadPlus", "NumpadEnter", "Numpad1",    "Numpad2",     "Numpad3",    "Numpad4",
          "Numpad5",    "Numpad6",     "Numpad7",    "Numpad8",     "Numpad9",    "Numpad0",
          "NumpadPoint"}},
        {0x65, {"Menu"}},
        {FIRST_MODIFIER,
         {"Ctrl", "Shift", "Alt", "Win", "RightCtrl", "RightShift", "RightAlt", "RightWin"}},
    };
    return rows;
}

}  // namespace

std::uint8_t hid_usage(std::uint16_t scan_code) {
    for (const Key& key : keys()) {
        if (key.code != scan_code) continue;
        for (const UsageRow& row : usage_rows()) {
            const auto at = std::find(row.names.begin(), row.names.end(), key.name);
            if (at != row.names.end())
                return static_cast<std::uint8_t>(row.first + (at - row.names.begin()));
        }
    }
    return 0;
}

UsbKeyboard::UsbKeyboard(Agenda& agenda, bool is_plugged)
    : UsbDevice{{UsbPlug::KEYBOARD, "USB Keyboard", 0x04D9, 0x0001, 0x0111, 1, 1, KEYBOARD_REPORT},
                is_plugged},
      strike_{agenda, [this] { strike(); }} {
    reset();
}

UsbBytes UsbKeyboard::report(bool) const {
    constexpr std::uint8_t TOO_MANY = 0x01;
    constexpr std::size_t MOST = 6;
    UsbBytes bytes(2);
    for (const std::uint8_t usage : held_)
        if (usage >= FIRST_MODIFIER)
            bytes[0] = static_cast<std::uint8_t>(bytes[0] | 1u << (usage - FIRST_MODIFIER));
        else
            bytes.push_back(usage);
    const bool too_many = bytes.size() > 2 + MOST;
    bytes.resize(2 + MOST);
    if (too_many) std::fill(bytes.begin() + 2, bytes.end(), TOO_MANY);
    return bytes;
}

void UsbKeyboard::move(std::uint16_t key, bool down) {
    const std::uint8_t usage = hid_usage(key);
    const auto at = std::find(held_.begin(), held_.end(), usage);
    if (usage == 0 || (at != held_.end()) == down) return;
    if (down)
        held_.push_back(usage);
    else
        held_.erase(at);
    if (!is_plugged()) return;
    hear_(key, down);
    changed();
}

void UsbKeyboard::type(const std::string& text) {
    typed_.insert(typed_.end(), text.begin(), text.end());
    if (!strike_.is_set()) strike_.set_in(0);
}

void UsbKeyboard::strike() {
    constexpr std::uint64_t KEY_TIME_PS = 20'000'000'000;
    if (struck_) {
        release(struck_->key);
        if (struck_->shift) release(LEFT_SHIFT);
        struck_.reset();
    } else {
        if (typed_.empty()) return;
        struck_ = stroke(typed_.front()).value();
        typed_.pop_front();
        if (struck_->shift) press(LEFT_SHIFT);
        press(struck_->key);
    }
    strike_.set_in(KEY_TIME_PS);
}

}  // namespace sim
