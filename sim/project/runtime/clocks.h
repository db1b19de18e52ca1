// clocks.h - when the clock inputs of de1sim_chip move: CLOCK_50, the video decoder's, the PLLs'.
//
// A clock of a PLL that drives pins of the chip alone moves nothing in the design.  Its input can
// be held high: then none of its edges is an evaluation, and the design shows whether it lets the
// clock through to the pin.
//
// Of a clock of which nothing sees more than the rise, each change of the input is one: the design
// makes a pulse of it (de1sim_clock_pulse.v).
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

    // All begin low.  `holds`: the clocks that only pins see, and those that nothing sees; not for
    // waveforms, which show them.
    Clocks(const DesignFacts& design, bool holds) {
        pins_ = holds ? design.clock_50_pins : 0;
        add(CLOCK_50_FS, CLOCK_50_FS, CLOCK_50_FS / 2, IS_CLOCK_50, pins_,
            design.pulses && design.clock_50_only_rises);
        if (design.td_clk27_used) add(CLOCK_27_FS, CLOCK_27_FS, CLOCK_27_FS / 2, IS_CLOCK_27);
        for (unsigned n = 0; n < design.pll_clock_count; ++n) {
            const PllTimes& pll = design.pll_clocks[n];
            if (holds && !pll.is_seen) continue;
            const bool pulses = pll.high_fs > 0 && pll.high_fs < pll.period_fs;
            const unsigned pins = holds ? pll.pins : 0;
            add(CLOCK_50_FS + pll.phase_fs, pll.period_fs, pulses ? pll.high_fs : pll.period_fs / 2,
                n, pins, design.pulses && pll.only_rises);
            if (pins) held_ |= std::uint64_t{1} << n;
            pins_ |= pins;
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

    // Of pll_clocks_i, and the bits of clocks_o that belong to them.
    std::uint64_t held() const { return held_; }
    unsigned pins() const { return pins_; }

    struct Edges {
        bool seen;             // by the design
        unsigned rising_pins;  // of pins()
    };
    // Calls move(number, rises) for each that moves then and is not held: a PLL's clock, or one of
    // the above.  It returns whether the design sees that.
    template <class Move>
    Edges edges(Move move) {
        const std::uint64_t now_fs = next_fs_;
        std::uint64_t next_fs = NEVER;
        Edges edges{false, 0};
        for (Clock& clock : clocks_) {
            if (clock.next_fs == now_fs) {
                clock.high = !clock.high;
                clock.next_fs += clock.high ? clock.high_fs : clock.low_fs;
                if (clock.high || clock.only_rises) edges.rising_pins |= clock.pins;
                if (!clock.is_held) edges.seen |= move(clock.number, clock.high);
            }
            next_fs = std::min(next_fs, clock.next_fs);
        }
        next_fs_ = next_fs;
        return edges;
    }

private:
    struct Clock {
        std::uint64_t next_fs, high_fs, low_fs;
        unsigned number, pins;
        bool only_rises, is_held, high;
    };
    void add(std::uint64_t rises_fs, std::uint64_t period_fs, std::uint64_t high_fs,
             unsigned number, unsigned pins = 0, bool only_rises = false) {
        if (only_rises) high_fs = period_fs, period_fs *= 2;
        const bool is_held = pins && number != IS_CLOCK_50;
        clocks_.push_back(
            {rises_fs, high_fs, period_fs - high_fs, number, pins, only_rises, is_held, false});
    }

    std::uint64_t next_fs_ = NEVER, held_ = 0;
    unsigned pins_ = 0;
    std::vector<Clock> clocks_;
};

}  // namespace sim::project
