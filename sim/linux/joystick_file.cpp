#include "sim/linux/joystick_file.h"

#include <sys/stat.h>

#include <algorithm>
#include <cstring>

namespace sim {

namespace {

constexpr std::uint8_t BUTTON = 1, AXIS = 2, AT_FIRST = 0x80;
constexpr std::uint16_t FIRST_BUTTON = 0x100;  // BTN_MISC
constexpr int MOST = 32767;

bool is_on(const std::vector<std::uint8_t>& bits, unsigned number) {
    return bits[number / 8] >> number % 8 & 1;
}

}  // namespace

JoystickFile::JoystickFile(std::shared_ptr<InputDevice> device, unsigned number)
    : device_{std::move(device)}, number_{number} {
    for (const auto& [code, axis] : device_->axes()) {
        axes_.push_back(static_cast<std::uint8_t>(code));
        places_.push_back(stretched(code, axis.value));
    }
    const std::vector<std::uint8_t> keys = device_->bits(input_event::KEY);
    const unsigned count = InputDevice::codes_of(input_event::KEY);
    for (unsigned code = input_event::BTN_JOYSTICK; code < count; ++code)
        if (is_on(keys, code)) buttons_.push_back(static_cast<std::uint16_t>(code));
    for (unsigned code = FIRST_BUTTON; code < input_event::BTN_JOYSTICK; ++code)
        if (is_on(keys, code)) buttons_.push_back(static_cast<std::uint16_t>(code));
    begin(static_cast<std::uint32_t>(device_->now_ns() / 1'000'000));
}

void JoystickFile::begin(std::uint32_t ms) {
    const std::vector<std::uint8_t> held = device_->bits(input_event::KEY, true);
    queue_.clear();
    for (std::size_t i = 0; i < buttons_.size(); ++i)
        queue_.push_back({ms, static_cast<std::int16_t>(is_on(held, buttons_[i])),
                          BUTTON | AT_FIRST, static_cast<std::uint8_t>(i)});
    for (std::size_t i = 0; i < axes_.size(); ++i)
        queue_.push_back({ms, places_[i], AXIS | AT_FIRST, static_cast<std::uint8_t>(i)});
}

// As joydev's correction of kind JS_CORR_BROKEN, with the coefficients that it computes itself.
std::int16_t JoystickFile::stretched(std::uint16_t code, std::int32_t value) const {
    const InputDevice::Axis& axis = device_->axes().at(code);
    const std::int32_t middle = (axis.most + axis.least) / 2;
    const std::int32_t reach = (axis.most - axis.least) / 2 - 2 * axis.flat;
    const std::int32_t slope = reach == 0 ? 0 : (1 << 29) / reach;
    const std::int32_t low = middle - axis.flat, high = middle + axis.flat;
    const std::int64_t way = value > low ? (value < high ? 0 : value - high) : value - low;
    return static_cast<std::int16_t>(std::clamp<std::int64_t>((way * slope) >> 14, -MOST, MOST));
}

FileStatus JoystickFile::status() const {
    return {S_IFCHR | 0664, 0, 1, input_event::MAJOR << 8 | number_};
}

unsigned JoystickFile::can_do() const {
    return (queue_.empty() ? 0 : READ) | (device_->exists() ? 0 : HUNG_UP | BROKEN);
}

void JoystickFile::hear(const InputEvent& event) {
    const auto ms = static_cast<std::uint32_t>(event.s * 1000 + event.us / 1000);
    Event told{ms, 0, 0, 0};
    if (event.type == input_event::KEY && event.value != 2) {
        const auto at = std::find(buttons_.begin(), buttons_.end(), event.code);
        if (at == buttons_.end()) return;
        told = {ms, static_cast<std::int16_t>(event.value), BUTTON,
                static_cast<std::uint8_t>(at - buttons_.begin())};
    } else if (event.type == input_event::ABS) {
        const auto at = std::find(axes_.begin(), axes_.end(), event.code);
        if (at == axes_.end()) return;
        const auto number = static_cast<std::uint8_t>(at - axes_.begin());
        const std::int16_t place = stretched(event.code, event.value);
        if (places_[number] == place) return;
        places_[number] = place;
        told = {ms, place, AXIS, number};
    } else {
        return;
    }
    constexpr std::size_t MOST_EVENTS = 64;
    if (queue_.size() >= MOST_EVENTS)
        begin(ms);
    else
        queue_.push_back(told);
    ++arrivals_;
}

std::int64_t JoystickFile::read(void* data, std::size_t bytes) {
    static_assert(sizeof(Event) == 8);
    if (!device_->exists()) return -ENODEV;
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

std::int64_t JoystickFile::control(std::uint32_t request, std::uint32_t at, AddressSpace& memory) {
    constexpr std::uint32_t LETTER = 'j', VERSION = 0x01, AXES = 0x11, BUTTONS = 0x12, NAME = 0x13,
                            CORRECTIONS = 0x22, AXIS_MAP = 0x32, BUTTON_MAP = 0x34, TO_PROGRAM = 2;
    if (!device_->exists()) return -ENODEV;
    if ((request >> 8 & 0xFF) != LETTER) return -ENOTTY;  // FIONBIO and so on
    if (request >> 30 != TO_PROGRAM) return -EINVAL;
    const std::size_t room = request >> 16 & 0x3FFF;
    const auto give = [&](const void* from, std::size_t bytes) -> std::int64_t {
        const std::size_t count = std::min(room, bytes);
        return memory.write(at, from, count) ? static_cast<std::int64_t>(count) : -EFAULT;
    };
    const auto give_all = [&](const void* from, std::size_t bytes) {
        return std::min<std::int64_t>(0, give(from, bytes));
    };
    const std::uint32_t version = 0x020100;
    const auto axes = static_cast<std::uint8_t>(axes_.size()),
               buttons = static_cast<std::uint8_t>(buttons_.size());
    const std::string& name = device_->about().name;
    switch (request & 0xFF) {
        case VERSION: return give_all(&version, sizeof version);
        case AXES: return give_all(&axes, sizeof axes);
        case BUTTONS: return give_all(&buttons, sizeof buttons);
        case NAME: return give(name.c_str(), name.size() + 1);
        case AXIS_MAP: return give(axes_.data(), axes_.size());
        case BUTTON_MAP: return give(buttons_.data(), 2 * buttons_.size());
        case CORRECTIONS: {
            std::vector<std::uint32_t> all;  // struct js_corr
            for (const auto& [code, axis] : device_->axes()) {
                const std::int32_t middle = (axis.most + axis.least) / 2;
                const std::int32_t reach = (axis.most - axis.least) / 2 - 2 * axis.flat;
                const auto slope = static_cast<std::uint32_t>(reach == 0 ? 0 : (1 << 29) / reach);
                for (const std::int32_t end : {middle - axis.flat, middle + axis.flat})
                    all.push_back(static_cast<std::uint32_t>(end));
                for (const std::uint32_t word : {slope, slope, 0u, 0u, 0u, 0u, 1u << 16})
                    all.push_back(word);
            }
            return give_all(all.data(), 4 * all.size());
        }
        default: return -EINVAL;
    }
}

}  // namespace sim
