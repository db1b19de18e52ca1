#include "sim/linux/mice_file.h"

#include <sys/stat.h>

#include <algorithm>
#include <array>

namespace sim {

namespace {

constexpr std::uint8_t ACKNOWLEDGED = 0xFA, PASSED = 0xAA;

}  // namespace

FileStatus MiceFile::status() const {
    return {S_IFCHR | 0660, 0, 1, input_event::MAJOR << 8 | number_};
}

unsigned MiceFile::can_do() const {
    return (moved_ || !answer_.empty() ? READ : 0) | (is_gone() ? HUNG_UP | BROKEN : WRITE);
}

std::int64_t MiceFile::read(void* data, std::size_t bytes) {
    if (is_gone()) return -ENODEV;
    if (answer_.empty() && moved_) report();
    if (answer_.empty()) return bytes == 0 ? 0 : -EAGAIN;
    const std::size_t count = std::min(bytes, answer_.size());
    std::copy_n(answer_.begin(), count, static_cast<std::uint8_t*>(data));
    answer_.erase(answer_.begin(), answer_.begin() + static_cast<std::ptrdiff_t>(count));
    return static_cast<std::int64_t>(count);
}

std::int64_t MiceFile::write(const void* data, std::size_t bytes) {
    const auto* const all = static_cast<const std::uint8_t*>(data);
    for (std::size_t i = 0; i < bytes; ++i) command(all[i]);
    return static_cast<std::int64_t>(bytes);
}

void MiceFile::hear(const InputEvent& event) {
    if (event.type == input_event::REL) {
        if (event.code == input_event::REL_X) right_ += event.value;
        if (event.code == input_event::REL_Y) up_ -= event.value;
        if (event.code == input_event::REL_WHEEL) wheel_ -= event.value;
        moved_ = true;
    }
    if (event.type == input_event::KEY && event.code >= input_event::BTN_LEFT) {
        const unsigned bit = 1u << (event.code - input_event::BTN_LEFT);
        buttons_ = static_cast<std::uint8_t>(event.value ? buttons_ | bit : buttons_ & ~bit);
        moved_ = true;
    }
}

void MiceFile::report() {
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

void MiceFile::command(std::uint8_t byte) {
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

}  // namespace sim
