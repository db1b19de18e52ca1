#include "sim/linux/input.h"

#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <deque>

#include "sim/board/scan_codes.h"

namespace sim {

namespace {

constexpr std::uint16_t EV_SYNC = 0, EV_OF_KEY = 1, EV_RELATIVE = 2, SYNC_DROPPED = 3;
constexpr std::uint16_t RELATIVE_X = 0, RELATIVE_Y = 1, RELATIVE_WHEEL = 8, BUTTON_LEFT = 0x110;
constexpr unsigned KEY_COUNT = 0x300;

// Linux's numbers of keys, by the names of ours, in rows of consecutive numbers.
struct KeyRow {
    std::uint16_t first;
    std::vector<std::string> names;
};

const std::vector<KeyRow>& key_rows() {
    static const std::vector<KeyRow> rows{
        {1, {"Esc",        "1",           "2",       "3",          "4",          "5",
             "6",          "7",           "8",       "9",          "0",          "-",
             "=",          "Backspace",   "Tab",     "q",          "w",          "e",
             "r",          "t",           "y",       "u",          "i",          "o",
             "p",          "[",           "]",       "Enter",      "Ctrl",       "a",
             "s",          "d",           "f",       "g",          "h",          "j",
             "k",          "l",           ";",       "'",          "`",          "Shift",
             "\\",         "z",           "x",       "c",          "v",          "b",
             "n",          "m",           ",",       ".",          "/",          "RightShift",
             "NumpadStar", "Alt",         "Space",   "CapsLock",   "F1",         "F2",
             "F3",         "F4",          "F5",      "F6",         "F7",         "F8",
             "F9",         "F10",         "NumLock", "ScrollLock", "Numpad7",    "Numpad8",
             "Numpad9",    "NumpadMinus", "Numpad4", "Numpad5",    "Numpad6",    "NumpadPlus",
             "Numpad1",    "Numpad2",     "Numpad3", "Numpad0",    "NumpadPoint"}},
        {87, {"F11", "F12"}},
        {96, {"NumpadEnter", "RightCtrl", "NumpadSlash", "PrintScreen", "RightAlt"}},
        {102,
         {"Home", "Up", "PageUp", "Left", "Right", "End", "Down", "PageDown", "Insert", "Delete"}},
        {119, {"Pause"}},
        {125, {"Win", "RightWin", "Menu"}},
    };
    return rows;
}

// 0: Linux has none for it.
std::uint16_t key_number(std::uint16_t scan_code) {
    for (const Key& key : keys()) {
        if (key.code != scan_code) continue;
        for (const KeyRow& row : key_rows()) {
            const auto at = std::find(row.names.begin(), row.names.end(), key.name);
            if (at != row.names.end())
                return static_cast<std::uint16_t>(row.first + (at - row.names.begin()));
        }
    }
    return 0;
}

}  // namespace

// ---- /dev/input/event* --------------------------------------------------------------------------

class LinuxInput::Events final : public LinuxDevice {
public:
    explicit Events(bool of_mouse) : mouse{of_mouse} {}

    FileStatus status() const override {
        return {S_IFCHR | 0660, 0, 1, 13u << 8 | (mouse ? 65u : 64u)};
    }
    std::string name() const override { return mouse ? "the USB mouse" : "the USB keyboard"; }
    unsigned can_do() const override { return (queue_.empty() ? 0 : READ) | WRITE; }
    std::int64_t read(void* data, std::size_t bytes) override {
        if (bytes < sizeof(Event)) return -EINVAL;
        if (queue_.empty()) return -EAGAIN;
        std::size_t count = 0;
        for (; (count + 1) * sizeof(Event) <= bytes && !queue_.empty(); ++count) {
            std::memcpy(static_cast<char*>(data) + count * sizeof(Event), &queue_.front(),
                        sizeof(Event));
            queue_.pop_front();
        }
        return static_cast<std::int64_t>(count * sizeof(Event));
    }
    std::int64_t write(const void*, std::size_t bytes) override {  // LEDs, repetition
        return static_cast<std::int64_t>(bytes);
    }
    std::int64_t control(std::uint32_t request, std::uint32_t at, AddressSpace& memory) override;

    void add(std::uint64_t ns, std::uint16_t type, std::uint16_t code, int value) {
        constexpr std::size_t MOST = 256;
        if (type == EV_OF_KEY && code < KEY_COUNT) held_[code / 8] = flipped(code, value != 0);
        const Event event{static_cast<std::uint32_t>(ns / 1'000'000'000),
                          static_cast<std::uint32_t>(ns / 1000 % 1'000'000), type, code, value};
        if (queue_.size() >= MOST) {
            queue_.clear();
            queue_.push_back({event.s, event.us, EV_SYNC, SYNC_DROPPED, 0});
        }
        queue_.push_back(event);
    }

    const bool mouse;

private:
    struct Event {
        std::uint32_t s, us;
        std::uint16_t type, code;
        std::int32_t value;
    };
    static_assert(sizeof(Event) == 16);

    std::uint8_t flipped(std::uint16_t code, bool on) const {
        const auto bit = static_cast<std::uint8_t>(1u << code % 8);
        const std::uint8_t was = held_[code / 8];
        return static_cast<std::uint8_t>(on ? was | bit : was & ~bit);
    }

    std::deque<Event> queue_;
    std::array<std::uint8_t, KEY_COUNT / 8> held_{};
};

// The requests of which a program learns what a device is and can do.
std::int64_t LinuxInput::Events::control(std::uint32_t request, std::uint32_t at,
                                         AddressSpace& memory) {
    constexpr std::uint32_t LETTER = 'E', VERSION = 0x01, IDENTITY = 0x02, REPEAT = 0x03,
                            NAME = 0x06, PLACE = 0x07, UNIQUE = 0x08, PROPERTIES = 0x09,
                            HELD_KEYS = 0x18, LAMPS = 0x19, TYPES = 0x20, GRAB = 0x90, CLOCK = 0xA0;
    if ((request >> 8 & 0xFF) != LETTER) return -ENOTTY;
    const std::uint32_t what = request & 0xFF, room = request >> 16 & 0x3FFF;
    std::vector<std::uint8_t> answer;
    const auto add_bit = [&answer](unsigned bit) {
        if (answer.size() <= bit / 8) answer.resize(bit / 8 + 1);
        answer[bit / 8] = static_cast<std::uint8_t>(answer[bit / 8] | 1u << bit % 8);
    };
    const auto add_text = [&answer](const std::string& text) {
        answer.assign(text.begin(), text.end());
        answer.push_back(0);
    };
    const auto add_words = [&answer](std::initializer_list<std::uint32_t> words) {
        for (const std::uint32_t word : words)
            for (unsigned i = 0; i < 32; i += 8)
                answer.push_back(static_cast<std::uint8_t>(word >> i));
    };
    switch (what) {
        case VERSION: add_words({0x010001}); break;
        case IDENTITY: add_words({mouse ? 0x046D0003u : 0x04D90003u, 0x01110001u}); break;
        case REPEAT: add_words({250, 33}); break;
        case NAME: add_text(mouse ? "USB Optical Mouse" : "USB Keyboard"); break;
        case PLACE:
            add_text(mouse ? "usb-ffb40000.usb-1.2/input0" : "usb-ffb40000.usb-1.1/input0");
            break;
        case UNIQUE: return -ENOENT;
        case PROPERTIES:
        case LAMPS: answer.resize(1); break;
        case HELD_KEYS: answer.assign(held_.begin(), held_.end()); break;
        case TYPES:
            for (const unsigned type : {EV_SYNC, EV_OF_KEY}) add_bit(type);
            if (mouse) add_bit(EV_RELATIVE);
            break;
        case TYPES + EV_OF_KEY:
            if (mouse) {
                for (unsigned i = 0; i < 3; ++i) add_bit(BUTTON_LEFT + i);
                break;
            }
            for (const KeyRow& row : key_rows())
                for (unsigned i = 0; i < row.names.size(); ++i) add_bit(row.first + i);
            break;
        case TYPES + EV_RELATIVE:
            if (mouse)
                for (const unsigned axis : {RELATIVE_X, RELATIVE_Y, RELATIVE_WHEEL}) add_bit(axis);
            break;
        case GRAB:
        case CLOCK: return 0;
        default:
            if (what < TYPES || what >= TYPES + 0x20) return -EINVAL;
            answer.resize(1);
    }
    const std::size_t count = std::min<std::size_t>(room, answer.size());
    return memory.write(at, answer.data(), count) ? static_cast<std::int64_t>(count) : -EFAULT;
}

// ---- /dev/input/mice ----------------------------------------------------------------------------

class LinuxInput::Mice final : public LinuxDevice {
public:
    FileStatus status() const override { return {S_IFCHR | 0660, 0, 1, 13u << 8 | 63u}; }
    std::string name() const override { return "the USB mouse"; }
    unsigned can_do() const override { return (moved_ || !answer_.empty() ? READ : 0) | WRITE; }
    std::int64_t read(void* data, std::size_t bytes) override {
        if (answer_.empty() && moved_) report();
        if (answer_.empty()) return bytes == 0 ? 0 : -EAGAIN;
        const std::size_t count = std::min(bytes, answer_.size());
        std::copy_n(answer_.begin(), count, static_cast<std::uint8_t*>(data));
        answer_.erase(answer_.begin(), answer_.begin() + static_cast<std::ptrdiff_t>(count));
        return static_cast<std::int64_t>(count);
    }
    std::int64_t write(const void* data, std::size_t bytes) override {
        const auto* const all = static_cast<const std::uint8_t*>(data);
        for (std::size_t i = 0; i < bytes; ++i) command(all[i]);
        return static_cast<std::int64_t>(bytes);
    }

    void add(int right, int up, int notches) {
        right_ += right, up_ += up, wheel_ += notches;
        moved_ = true;
    }
    void press(unsigned which, bool down) {
        buttons_ =
            static_cast<std::uint8_t>(down ? buttons_ | 1u << which : buttons_ & ~(1u << which));
        moved_ = true;
    }

private:
    static constexpr std::uint8_t ACKNOWLEDGED = 0xFA, PASSED = 0xAA;

    void report() {
        const int right = std::clamp(right_, -127, 127), up = std::clamp(up_, -127, 127);
        const int wheel = std::clamp(wheel_, -7, 7);
        answer_ = {
            static_cast<std::uint8_t>(8 | (right < 0 ? 0x10 : 0) | (up < 0 ? 0x20 : 0) | buttons_),
            static_cast<std::uint8_t>(right), static_cast<std::uint8_t>(up)};
        if (has_wheel_) answer_.push_back(static_cast<std::uint8_t>(wheel));
        right_ -= right, up_ -= up;
        wheel_ = has_wheel_ ? wheel_ - wheel : 0;
        moved_ = right_ != 0 || up_ != 0 || wheel_ != 0;
    }
    void command(std::uint8_t byte) {
        constexpr std::array<std::uint8_t, 6> ASKS_FOR_A_WHEEL{0xF3, 200, 0xF3, 100, 0xF3, 80};
        constexpr std::uint8_t IDENTIFY = 0xF2, RESET = 0xFF;
        asked_ = byte == ASKS_FOR_A_WHEEL[asked_] ? asked_ + 1 : byte == 0xF3 ? 1 : 0;
        if (asked_ == ASKS_FOR_A_WHEEL.size()) {
            asked_ = 0;
            has_wheel_ = true;
        }
        answer_ = {ACKNOWLEDGED};
        if (byte == IDENTIFY) answer_.push_back(has_wheel_ ? 3 : 0);
        if (byte != RESET) return;
        has_wheel_ = false;
        answer_ = {ACKNOWLEDGED, PASSED, 0};
    }

    int right_ = 0, up_ = 0, wheel_ = 0;
    std::uint8_t buttons_ = 0;
    bool moved_ = false, has_wheel_ = false;
    std::size_t asked_ = 0;
    std::vector<std::uint8_t> answer_;
};

// ---- All of them --------------------------------------------------------------------------------

bool LinuxInput::has(const std::string& path) {
    return path == "/dev/input/event0" || path == "/dev/input/event1" ||
           path == "/dev/input/mice" || path == "/dev/input/mouse0";
}

std::shared_ptr<LinuxDevice> LinuxInput::open(const std::string& path) {
    if (!has(path)) return nullptr;
    if (path.find("event") == std::string::npos) {
        const auto device = std::make_shared<Mice>();
        mice_.push_back(device);
        return device;
    }
    const auto device = std::make_shared<Events>(path.back() == '1');
    events_.push_back(device);
    return device;
}

void LinuxInput::queue_event(bool mouse, std::uint16_t type, std::uint16_t code, int value) {
    for (auto it = events_.begin(); it != events_.end();) {
        const auto device = it->lock();
        if (device && device->mouse == mouse) device->add(now_ns_(), type, code, value);
        it = device ? std::next(it) : events_.erase(it);
    }
    mice_.erase(
        std::remove_if(mice_.begin(), mice_.end(), [](const auto& m) { return m.expired(); }),
        mice_.end());
}

void LinuxInput::queue_sync(bool mouse) { queue_event(mouse, EV_SYNC, 0, 0); }

void LinuxInput::key(std::uint16_t code, bool down) {
    const std::uint16_t number = key_number(code);
    if (number == 0) return;
    queue_event(false, EV_OF_KEY, number, down);
    queue_sync(false);
    notify_();
}

void LinuxInput::move(int right, int up) {
    if (right != 0) queue_event(true, EV_RELATIVE, RELATIVE_X, right);
    if (up != 0) queue_event(true, EV_RELATIVE, RELATIVE_Y, -up);
    if (right != 0 || up != 0) queue_sync(true);
    for (const auto& device : mice_)
        if (const auto one = device.lock()) one->add(right, up, 0);
    notify_();
}

void LinuxInput::turn(int notches) {
    queue_event(true, EV_RELATIVE, RELATIVE_WHEEL, -notches);
    queue_sync(true);
    for (const auto& device : mice_)
        if (const auto one = device.lock()) one->add(0, 0, notches);
    notify_();
}

void LinuxInput::button(unsigned which, bool down) {
    queue_event(true, EV_OF_KEY, static_cast<std::uint16_t>(BUTTON_LEFT + which), down);
    queue_sync(true);
    for (const auto& device : mice_)
        if (const auto one = device.lock()) one->press(which, down);
    notify_();
}

}  // namespace sim
