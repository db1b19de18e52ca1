// linear.h - numbers of 32 bits that grow by the same amount in each round of a loop, and for how
// many rounds a comparison of two of them comes out the same.
//
// Round n, from 0, has the value base + n * step, modulo 2^32.  A bound is a number of rounds: in
// so many, from round 0 on, the answer is that of round 0.  It may be too low where a value wraps
// around, never too high.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>

namespace sim {

struct Linear {
    std::uint32_t base = 0, step = 0;

    bool fixed() const { return step == 0; }
    friend Linear operator+(const Linear& a, const Linear& b) {
        return {a.base + b.base, a.step + b.step};
    }
    friend Linear operator-(const Linear& a, const Linear& b) {
        return {a.base - b.base, a.step - b.step};
    }
    friend bool operator==(const Linear& a, const Linear& b) {
        return a.base == b.base && a.step == b.step;
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

// For how many rounds `value` does not wrap around, as an unsigned or a signed number.
inline std::uint64_t rounds_unsigned(const Linear& value) {
    return rounds_within(value.base, static_cast<std::int32_t>(value.step), 0, 0xFFFFFFFF);
}
inline std::uint64_t rounds_signed(const Linear& value) {
    return rounds_within(static_cast<std::int32_t>(value.base),
                         static_cast<std::int32_t>(value.step), INT32_MIN, INT32_MAX);
}

// ... the difference of zero or not stays that.
inline std::uint64_t rounds_zero(const Linear& difference) {
    if (difference.fixed()) return ALL_ROUNDS;
    if (difference.base == 0) return 1;
    return rounds_within(difference.base, static_cast<std::int32_t>(difference.step), 1,
                         0xFFFFFFFF);
}
// ... its sign stays.
inline std::uint64_t rounds_sign(const Linear& difference) {
    const auto start = static_cast<std::int32_t>(difference.base);
    return rounds_within(start, static_cast<std::int32_t>(difference.step),
                         start < 0 ? INT32_MIN : 0, start < 0 ? -1 : INT32_MAX);
}
// ... the order of two true numbers, of which a - b = start + n * step, stays: less, or not less.
inline std::uint64_t rounds_ordered(std::int64_t start, std::int64_t step) {
    constexpr std::int64_t FAR = std::int64_t{1} << 40;
    return rounds_within(start, step, start < 0 ? -FAR : 0, start < 0 ? -1 : FAR);
}
// ... a < b, unsigned or signed, stays that.
inline std::uint64_t rounds_below(const Linear& a, const Linear& b) {
    const std::int64_t step = std::int64_t{static_cast<std::int32_t>(a.step)} -
                              std::int64_t{static_cast<std::int32_t>(b.step)};
    return std::min({rounds_unsigned(a), rounds_unsigned(b),
                     rounds_ordered(std::int64_t{a.base} - std::int64_t{b.base}, step)});
}
inline std::uint64_t rounds_less(const Linear& a, const Linear& b) {
    const std::int64_t step = std::int64_t{static_cast<std::int32_t>(a.step)} -
                              std::int64_t{static_cast<std::int32_t>(b.step)};
    return std::min({rounds_signed(a), rounds_signed(b),
                     rounds_ordered(std::int64_t{static_cast<std::int32_t>(a.base)} -
                                        std::int64_t{static_cast<std::int32_t>(b.base)},
                                    step)});
}

}  // namespace sim
