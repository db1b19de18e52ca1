// clocks.h - when the clock inputs of de1sim_chip move: CLOCK_50, the video decoder's, the PLLs'.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "sim/project/runtime/design.h"

namespace sim::project {

constexpr std::uint64_t CLOCK_50_FS = 20'000'000, CLOCK_27_FS = 37'037'037;
constexpr std::uint64_t NEVER = ~std::uint64_t{0};

class Clocks {
public:
    static constexpr unsigned IS_CLOCK_50 = 64, IS_CLOCK_27 = 65;

    // All begin low.
    explicit Clocks(const DesignFacts& design) {
        add(CLOCK_50_FS, CLOCK_50_FS, CLOCK_50_FS / 2, IS_CLOCK_50);
        if (design.td_clk27_used) add(CLOCK_27_FS, CLOCK_27_FS, CLOCK_27_FS / 2, IS_CLOCK_27);
        for (unsigned n = 0; n < design.pll_clock_count; ++n) {
            const PllTimes& pll = design.pll_clocks[n];
            const bool pulses = pll.high_fs > 0 && pll.high_fs < pll.period_fs;
            add(CLOCK_50_FS + pll.phase_fs, pll.period_fs, pulses ? pll.high_fs : pll.period_fs / 2,
                n);
        }
        for (const Clock& clock : clocks_) next_fs_ = std::min(next_fs_, clock.next_fs);
    }

    // From its next edge on, a PLL's clock has these times.
    void set(unsigned number, std::uint64_t period_fs, std::uint64_t high_fs) {
        if (high_fs == 0 || high_fs >= period_fs) return;
        for (Clock& clock : clocks_)
            if (clock.number == number) {
                clock.high_fs = high_fs;
                clock.low_fs = period_fs - high_fs;
            }
    }

    // When the next of them moves.
    std::uint64_t next_fs() const { return next_fs_; }

    // Calls move(number, rises) for each that moves then: a PLL's clock, or one of the above.
    template <class Move>
    void edges(Move move) {
        const std::uint64_t now_fs = next_fs_;
        std::uint64_t next_fs = NEVER;
        for (Clock& clock : clocks_) {
            if (clock.next_fs == now_fs) {
                clock.high = !clock.high;
                clock.next_fs += clock.high ? clock.high_fs : clock.low_fs;
                move(clock.number, clock.high);
            }
            next_fs = std::min(next_fs, clock.next_fs);
        }
        next_fs_ = next_fs;
    }

private:
    struct Clock {
        std::uint64_t next_fs, high_fs, low_fs;
        unsigned number;
        bool high;
    };
    void add(std::uint64_t rises_fs, std::uint64_t period_fs, std::uint64_t high_fs,
             unsigned number) {
        clocks_.push_back({rises_fs, high_fs, period_fs - high_fs, number, false});
    }

    std::uint64_t next_fs_ = NEVER;
    std::vector<Clock> clocks_;
};

}  // namespace sim::project
