// clocks.h - when the clock inputs of de1sim_chip move: CLOCK_50, the video decoder's, the PLLs'.
//
// An ordinary run makes a whole pulse of a clock in one evaluation, when it rises (de1sim_clock).
// In waveforms each edge has its own time.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "sim/project/runtime/chip.h"

namespace sim::project {

constexpr std::uint64_t CLOCK_50_FS = 20'000'000, CLOCK_27_FS = 37'037'037;
constexpr std::uint64_t NEVER = ~std::uint64_t{0};

class Clocks {
public:
    static constexpr unsigned IS_CLOCK_50 = 64, IS_CLOCK_27 = 65;

    explicit Clocks(const DesignFacts& design) : edges_apart_{design.edges_apart} {
        add(CLOCK_50_FS, CLOCK_50_FS, CLOCK_50_FS / 2, IS_CLOCK_50);
        if (design.td_clk27_used) add(CLOCK_27_FS, CLOCK_27_FS, CLOCK_27_FS / 2, IS_CLOCK_27);
        for (unsigned n = 0; n < design.pll_clock_count; ++n) {
            const PllTimes& pll = design.pll_clocks[n];
            const bool pulses = pll.high_fs > 0 && pll.high_fs < pll.period_fs;
            add(CLOCK_50_FS + pll.phase_fs, pll.period_fs, pulses ? pll.high_fs : pll.period_fs / 2,
                n);
        }
    }

    std::uint64_t next_clock_50_fs() const { return clocks_[0].rises_fs; }
    std::uint64_t next_rise_fs() const {
        std::uint64_t next = clocks_[0].rises_fs;
        for (const Clock& clock : clocks_) next = std::min(next, clock.rises_fs);
        return next;
    }
    // NEVER if none is high, which without waveforms none is.
    std::uint64_t next_fall_fs() const {
        std::uint64_t next = NEVER;
        if (edges_apart_)
            for (const Clock& clock : clocks_) next = std::min(next, clock.falls_fs);
        return next;
    }
    bool high() const { return next_fall_fs() != NEVER; }

    // Calls move(number, rises) for each that has an edge now: a PLL's clock, or one of the above.
    template <class Move>
    void edges(std::uint64_t now_fs, Move move) {
        for (Clock& clock : clocks_) {
            if (clock.rises_fs == now_fs) {
                clock.rises_fs += clock.period_fs;
                if (edges_apart_) clock.falls_fs = now_fs + clock.high_fs;
                move(clock.number, true);
            } else if (edges_apart_ && clock.falls_fs == now_fs) {
                clock.falls_fs = NEVER;
                move(clock.number, false);
            }
        }
    }

private:
    struct Clock {
        std::uint64_t rises_fs, falls_fs, period_fs, high_fs;
        unsigned number;
    };
    void add(std::uint64_t rises_fs, std::uint64_t period_fs, std::uint64_t high_fs,
             unsigned number) {
        clocks_.push_back({rises_fs, NEVER, period_fs, high_fs, number});
    }

    const bool edges_apart_;
    std::vector<Clock> clocks_;
};

}  // namespace sim::project
