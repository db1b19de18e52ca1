#include "sim/board/lamp.h"

#include <algorithm>

namespace sim {

namespace {

constexpr std::uint64_t LEAST_SHARE = 20;  // one in
constexpr std::uint8_t MANY = 6;

}  // namespace

void LampBank::pass(std::uint64_t time_ps) {
    while (time_ps >= begin_ps_ + SPAN_PS) {
        if (moved_ || moved_before_)
            end_span();
        else
            begin_ps_ += (time_ps - begin_ps_) / SPAN_PS * SPAN_PS;
    }
    now_ps_ = std::max(now_ps_, time_ps);
}

void LampBank::end_span() {
    now_ps_ = begin_ps_ + SPAN_PS;
    for (Lamp& lamp : lamps_) {
        lamp.lit_before_ps = lit_ps(lamp);
        lamp.lit_ps = 0;
        lamp.since_ps = now_ps_;
        lamp.moves_before = lamp.moves;
        lamp.moves = 0;
    }
    begin_ps_ = now_ps_;
    for (Lamp& lamp : lamps_) look(lamp);
    moved_before_ = moved_;
    moved_ = false;
    show();
}

void LampBank::light(unsigned number, bool lit) {
    Lamp& lamp = lamps_[number];
    if (lamp.lit == lit) return;
    lamp.lit_ps = lit_ps(lamp);
    lamp.since_ps = now_ps_;
    lamp.lit = lit;
    if (lamp.moves < MANY) ++lamp.moves;
    moved_ = true;
    look(lamp);
}

void LampBank::show() {
    if (!news_) return;
    news_ = false;
    if (notify_) notify_(now_ps_);
}

std::uint64_t LampBank::lit_ps(const Lamp& lamp) const {
    return lamp.lit_ps + (lamp.lit ? now_ps_ - std::max(lamp.since_ps, begin_ps_) : 0);
}

// There was nothing before power-on.
std::uint64_t LampBank::window_ps() const {
    return (begin_ps_ ? SPAN_PS : 0) + now_ps_ - begin_ps_;
}

void LampBank::look(Lamp& lamp) {
    const bool flashes = lamp.moves + lamp.moves_before >= MANY;
    const std::uint64_t lit = lamp.lit_before_ps + lit_ps(lamp);
    const bool seen = flashes ? lit * LEAST_SHARE >= window_ps() : lamp.lit;
    news_ = news_ || seen != lamp.seen;
    lamp.seen = seen;
}

double LampBank::brightness(unsigned number) const {
    const Lamp& lamp = lamps_[number];
    if (lamp.moves + lamp.moves_before == 0 || !window_ps()) return lamp.lit;
    return static_cast<double>(lamp.lit_before_ps + lit_ps(lamp)) /
           static_cast<double>(window_ps());
}

}  // namespace sim
