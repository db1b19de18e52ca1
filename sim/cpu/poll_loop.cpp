#include "sim/cpu/poll_loop.h"

#include <algorithm>

namespace sim {

std::uint64_t PollLoop::read(std::uint32_t pc, std::uint32_t address, std::uint32_t value,
                             std::uint64_t now) {
    return follow({pc, address, value, false}, now);
}

std::uint64_t PollLoop::write(std::uint32_t pc, std::uint32_t address, std::uint32_t value,
                              std::uint64_t now) {
    return follow({pc, address, value, true}, now);
}

std::optional<std::uint32_t> PollLoop::polled() const {
    if (rounds_ < ROUNDS) return std::nullopt;
    return std::find_if(cycle_.begin(), cycle_.end(), [](const Access& a) { return !a.write; })
        ->address;
}

void PollLoop::begin(const Access& access, std::uint64_t now) {
    *this = {};
    cycle_[0] = access;
    length_ = 1;
    since_ = now;
}

// At least one read, and no register that is written two values in turn.
bool PollLoop::may_repeat() const {
    const auto end = cycle_.begin() + length_;
    const auto is_undone = [&](const Access& one) {
        return one.write && std::any_of(cycle_.begin(), end, [&](const Access& other) {
                   return other.write && other.address == one.address && other.value != one.value;
               });
    };
    return writes_ < length_ && std::none_of(cycle_.begin(), end, is_undone);
}

std::uint64_t PollLoop::follow(const Access& access, std::uint64_t now) {
    if (!closed_ && length_ && access.is_at(cycle_[0])) {
        closed_ = true;
        writes_ = static_cast<unsigned>(std::count_if(cycle_.begin(), cycle_.begin() + length_,
                                                      [](const Access& a) { return a.write; }));
        harmless_ = may_repeat();
    }
    if (!closed_ && length_ && length_ < MOST) {
        cycle_[length_++] = access;
        return 0;
    }
    Access& expected = cycle_[next_];
    const bool same = access.value == expected.value;
    if (!closed_ || !harmless_ || !access.is_at(expected) || (access.write && !same)) {
        begin(access, now);
        return 0;
    }
    const bool round = next_ == 0;
    next_ = (next_ + 1) % length_;
    rounds_ += round;
    same_ = same ? same_ + round : 0;
    if (!same) {
        expected.value = access.value;
        since_ = now;
    }
    if (!round || rounds_ < ROUNDS) return 0;
    if (same_ >= ROUNDS) return std::min((now - since_) / 8, LONG_REST);
    return writes_ ? 0 : SHORT_REST;
}

}  // namespace sim
