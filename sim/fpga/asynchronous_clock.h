// asynchronous_clock.h - when another clock moves among the fabric's clocks, exactly
//
// The audio clock rises 128 times per sample: at 8,000 samples per second every 3,125 / 128 clocks
// of 25 MHz.  The video decoder's clock of 27 MHz rises every 25 / 27 clocks.  Nothing is rounded,
// so nothing drifts.  The phase between the clocks is unknown on the board; here no edge of theirs
// coincides with one of the fabric's.
#pragma once

#include <cstdint>
#include <numeric>

namespace sim {

constexpr std::uint64_t FABRIC_PERIOD_PS = 40'000;  // 25 MHz

class AsynchronousClock {
public:
    explicit AsynchronousClock(std::uint64_t hz) : AsynchronousClock{2 * hz, 25'000'000} {}

    // The next change: after so many whole clocks of the fabric, when, and whether it is a rise.
    std::uint64_t clocks() const { return clocks_; }
    std::uint64_t time_ps() const {
        return clocks_ * FABRIC_PERIOD_PS + part_ * FABRIC_PERIOD_PS / parts_;
    }
    bool rises() const { return changes_ % 2 == 0; }
    std::uint64_t number() const { return changes_ / 2; }  // of that rise, from 0
    // Whether it comes before so many halves of a clock.
    bool before(std::uint64_t halves) const { return 2 * clocks_ + (2 * part_ >= parts_) < halves; }

    void next() {
        ++changes_;
        clocks_ += half_clocks_;
        part_ += half_part_;
        if (part_ >= parts_) part_ -= parts_, ++clocks_;
    }

    // On to the first rise after so many whole clocks.
    void skip_to(std::uint64_t clocks) {
        const std::uint64_t periods = (clocks * parts_ + 2 * half_ - 1) / (2 * half_);
        const std::uint64_t first = periods ? periods - 1 : 0;  // rise n is n + 1 periods after 0
        const std::uint64_t at = 1 + 2 * half_ * (first + 1);
        changes_ = 2 * first;
        clocks_ = at / parts_;
        part_ = at % parts_;
    }

private:
    AsynchronousClock(std::uint64_t changes_per_s, std::uint64_t clocks_per_s)
        : half_{2 * clocks_per_s / std::gcd(changes_per_s, clocks_per_s)},
          parts_{2 * changes_per_s / std::gcd(changes_per_s, clocks_per_s)} {
        skip_to(0);  // it is low at first
    }

    std::uint64_t half_, parts_;  // half a period, a clock
    std::uint64_t half_clocks_ = half_ / parts_, half_part_ = half_ % parts_;
    std::uint64_t changes_ = 0;
    std::uint64_t clocks_ = 0, part_ = 1;  // the first would be one part after the beginning
};

inline AsynchronousClock audio_clock(unsigned samples_per_s) {
    return AsynchronousClock{128ull * samples_per_s};
}
inline AsynchronousClock decoder_clock() { return AsynchronousClock{27'000'000}; }

}  // namespace sim
