// linear.h - numbers of 32 bits that grow by the same amount in each round of a loop, or with the
// time that a round takes, and for how many rounds a comparison of two of them comes out the same.
//
// Round n, from 0, has the value base + n * step, modulo 2^32.  A counter that runs in time is a
// stair besides: by round n it has made (phase_ps + n * round_ps) / tick_ps steps, rounded down.  A
// bound is a number of rounds: in so many, from round 0 on, the answer is that of round 0.  It may
// be too low where a value wraps around, never too high.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>

namespace sim {

struct Stair {
    int sign = 0;  // of its steps; 0: there are none
    std::uint64_t tick_ps = 1, phase_ps = 0, round_ps = 0;

    friend bool operator==(const Stair& a, const Stair& b) {
        return a.sign == b.sign && (a.sign == 0 || a.is_of(b));
    }
    // They make their steps in the same rounds.
    bool is_of(const Stair& o) const {
        return tick_ps == o.tick_ps && phase_ps == o.phase_ps && round_ps == o.round_ps;
    }
};

struct Linear {
    std::uint32_t base = 0, step = 0;
    Stair stair{};
    bool unknown = false;  // a sum of two stairs

    bool fixed() const { return step == 0 && stair.sign == 0 && !unknown; }
    bool is_line() const { return stair.sign == 0 && !unknown; }
    std::uint32_t in_round(std::uint64_t n) const {
        const auto rounds = static_cast<std::uint32_t>(n);
        const std::uint64_t ps = stair.phase_ps + n * stair.round_ps;
        const auto steps = static_cast<std::uint32_t>(stair.sign ? ps / stair.tick_ps : 0);
        return base + rounds * step + (stair.sign < 0 ? 0 - steps : steps);
    }
    friend Linear operator-(const Linear& a) {
        Linear negative = a;
        negative.base = 0 - a.base;
        negative.step = 0 - a.step;
        negative.stair.sign = -a.stair.sign;
        return negative;
    }
    friend Linear operator+(const Linear& a, const Linear& b) {
        Linear sum{a.base + b.base, a.step + b.step, a.stair, a.unknown || b.unknown};
        if (a.stair.sign == 0)
            sum.stair = b.stair;
        else if (b.stair.sign == -a.stair.sign && a.stair.is_of(b.stair))
            sum.stair = {};
        else
            sum.unknown |= b.stair.sign != 0;
        return sum;
    }
    friend Linear operator-(const Linear& a, const Linear& b) { return a + -b; }
    friend bool operator==(const Linear& a, const Linear& b) {
        return a.base == b.base && a.step == b.step && a.stair == b.stair && !a.unknown &&
               !b.unknown;
    }
};

constexpr std::uint64_t ALL_ROUNDS = std::numeric_limits<std::uint64_t>::max();

// For how many rounds start + n * step stays within low ... high, where `start` is.
inline std::uint64_t rounds_within(std::int64_t start, std::int64_t step, std::int64_t low,
                                   std::int64_t high) {
    if (step == 0) return ALL_ROUNDS;
    const std::int64_t room = step > 0 ? high - start : start - low;
    return static_cast<std::uint64_t>(room / (step > 0 ? step : -step)) + 1;
}
// ... start and what `growth` adds to its base.
inline std::uint64_t rounds_within(std::int64_t start, const Linear& growth, std::int64_t low,
                                   std::int64_t high) {
    if (growth.is_line())
        return rounds_within(start, static_cast<std::int32_t>(growth.step), low, high);
    if (growth.unknown || growth.step != 0) return 1;
    const Stair& stair = growth.stair;
    const auto room = static_cast<std::uint64_t>(stair.sign > 0 ? high - start : start - low);
    return ((room + 1) * stair.tick_ps - 1 - stair.phase_ps) / stair.round_ps + 1;
}

// For how many rounds `value` does not wrap around, as an unsigned or a signed number.
inline std::uint64_t rounds_unsigned(const Linear& value) {
    return rounds_within(value.base, value, 0, 0xFFFFFFFF);
}
inline std::uint64_t rounds_signed(const Linear& value) {
    return rounds_within(static_cast<std::int32_t>(value.base), value, INT32_MIN, INT32_MAX);
}

// ... the difference of zero or not stays that.
inline std::uint64_t rounds_zero(const Linear& difference) {
    if (difference.base == 0) return rounds_within(0, difference, 0, 0);
    return rounds_within(difference.base, difference, 1, 0xFFFFFFFF);
}
// ... its sign stays.
inline std::uint64_t rounds_sign(const Linear& difference) {
    const auto start = static_cast<std::int32_t>(difference.base);
    return rounds_within(start, difference, start < 0 ? INT32_MIN : 0, start < 0 ? -1 : INT32_MAX);
}
// ... the order of two true numbers, of which a - b = start in round 0, stays: less, or not less.
inline std::uint64_t rounds_ordered(std::int64_t start, const Linear& a, const Linear& b) {
    constexpr std::int64_t FAR = std::int64_t{1} << 40;
    const std::int64_t low = start < 0 ? -FAR : 0, high = start < 0 ? -1 : FAR;
    if (!a.is_line() || !b.is_line()) return rounds_within(start, a - b, low, high);
    const std::int64_t step = std::int64_t{static_cast<std::int32_t>(a.step)} -
                              std::int64_t{static_cast<std::int32_t>(b.step)};
    return rounds_within(start, step, low, high);
}
// ... a < b, unsigned or signed, stays that.
inline std::uint64_t rounds_below(const Linear& a, const Linear& b) {
    return std::min({rounds_unsigned(a), rounds_unsigned(b),
                     rounds_ordered(std::int64_t{a.base} - std::int64_t{b.base}, a, b)});
}
inline std::uint64_t rounds_less(const Linear& a, const Linear& b) {
    return std::min({rounds_signed(a), rounds_signed(b),
                     rounds_ordered(std::int64_t{static_cast<std::int32_t>(a.base)} -
                                        std::int64_t{static_cast<std::int32_t>(b.base)},
                                    a, b)});
}

}  // namespace sim
