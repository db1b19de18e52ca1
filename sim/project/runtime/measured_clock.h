// measured_clock.h - the period of a clock on a pin, in fs
#pragma once

#include <cstdint>
#include <utility>

namespace sim::project {

class MeasuredClock {
public:
    // Without a rise for so long it stands still.
    static constexpr std::uint64_t QUIET_FS = 1'000'000'000'000;  // 1 ms

    // 0: it stands still, or has not risen often enough.
    std::uint64_t period_fs() const { return period_fs_; }
    // It rises at that time.  Returns whether the period becomes another by that.
    bool rises(std::uint64_t now_fs) {
        if (++rises_ % RISES) return false;
        const std::uint64_t before_fs = std::exchange(counted_fs_, now_fs);
        return before_fs && becomes((now_fs - before_fs) / RISES);
    }
    // The same, where it has not risen.
    bool stops(std::uint64_t now_fs) {
        if (counted_fs_ == 0 || now_fs <= counted_fs_ + QUIET_FS) return false;
        counted_fs_ = 0;
        return becomes(0);
    }

private:
    static constexpr unsigned RISES = 128;

    bool becomes(std::uint64_t period_fs) {
        return std::exchange(period_fs_, period_fs) != period_fs;
    }

    std::uint64_t rises_ = 0, counted_fs_ = 0, period_fs_ = 0;
};

}  // namespace sim::project
