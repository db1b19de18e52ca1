// lamp.h - lamps as a person sees them: what is lit for a part of the time is lit, too.
//
// A display may be multiplexed, and a lamp dimmed by switching it on and off.  Time is divided into
// spans of 20 ms.  A lamp's brightness is the share of the time in which it was lit, over the span
// before and what has passed of this one, so over 20 to 40 ms.
//
// A lamp that moved at least six times in that time, as one does that flashes 150 times a second,
// is seen lit from a brightness of 1/20 on.  Others are seen as they are, without a delay: one that
// stands still, and one that changes now and then.
//
// Work is done for lamps that move, and once a span for all of them while any has moved lately.
//
// Not handled: flicker between 50 and 150 times a second, which a person sees lit all the same.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

namespace sim {

class LampBank {
public:
    static constexpr std::uint64_t SPAN_PS = 20'000'000'000;

    // `notify` is called when a lamp is seen otherwise than before: by show(), and for the end of a
    // span by pass().
    explicit LampBank(unsigned count, std::function<void(std::uint64_t time_ps)> notify = {})
        : notify_{std::move(notify)}, lamps_(count) {}

    // What there is up to this time; then lamps move at it, and are shown together.
    void pass(std::uint64_t time_ps);
    void light(unsigned lamp, bool lit);
    void show();

    bool seen(unsigned lamp) const { return lamps_[lamp].seen; }
    double brightness(unsigned lamp) const;  // 0 to 1

private:
    struct Lamp {
        bool lit = false, seen = false;
        std::uint8_t moves = 0, moves_before = 0;  // in this span, in the one before; at most MANY
        std::uint64_t since_ps = 0;                // it has been counted up to here
        std::uint64_t lit_ps = 0, lit_before_ps = 0;  // likewise
    };

    std::uint64_t lit_ps(const Lamp& lamp) const;
    std::uint64_t window_ps() const;
    void look(Lamp& lamp);
    void end_span();

    std::function<void(std::uint64_t)> notify_;
    std::vector<Lamp> lamps_;
    std::uint64_t begin_ps_ = 0, now_ps_ = 0;  // of this span
    bool moved_ = false, moved_before_ = false;
    bool news_ = false;
};

}  // namespace sim
