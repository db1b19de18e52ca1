// audio_clock.h - when the audio clock moves among the fabric's clocks, exactly
//
// It rises 128 times a sample: for 8,000 a second each 3,125 / 128 clocks of 25 MHz.  Nothing is
// rounded, so nothing drifts.  On the board nobody knows the phase between the two clocks; here no
// edge of one meets an edge of the other.
#pragma once

#include <cstdint>
#include <numeric>

namespace sim {

constexpr std::uint64_t FABRIC_PERIOD_PS = 40'000;  // 25 MHz

class AudioClock {
public:
    explicit AudioClock(unsigned samples_per_s) : AudioClock{256ull * samples_per_s, 25'000'000} {}

    // The next change: behind so many whole clocks of the fabric, when, and whether it is a rise.
    std::uint64_t clocks() const { return clocks_; }
    std::uint64_t time_ps() const {
        return clocks_ * FABRIC_PERIOD_PS + part_ * FABRIC_PERIOD_PS / parts_;
    }
    bool rises() const { return rises_; }
    // Whether it comes before so many halves of a clock.
    bool before(std::uint64_t halves) const { return 2 * clocks_ + (2 * part_ >= parts_) < halves; }

    void next() {
        clocks_ += half_ / parts_;
        part_ += half_ % parts_;
        if (part_ >= parts_) part_ -= parts_, ++clocks_;
        rises_ = !rises_;
    }

private:
    AudioClock(std::uint64_t changes_per_s, std::uint64_t clocks_per_s)
        : half_{2 * clocks_per_s / std::gcd(changes_per_s, clocks_per_s)},
          parts_{2 * changes_per_s / std::gcd(changes_per_s, clocks_per_s)} {
        next();  // it is low at first
        next();
    }

    std::uint64_t half_, parts_;           // half a period, a clock
    std::uint64_t clocks_ = 0, part_ = 1;  // so many parts behind a clock
    bool rises_ = true;
};

}  // namespace sim
