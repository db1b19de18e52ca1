#include "sim/board/monitor.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace sim {

namespace {

constexpr std::uint32_t CONTROL = video::HS | video::VS | video::BLANK_N;
constexpr Placement STRICT_PLACE{640, 480};
constexpr std::uint64_t MS = 1'000'000'000;  // in ps
constexpr std::uint64_t LONGEST_FRAME = 100 * MS, PATIENCE = 1000 * MS;
constexpr unsigned MOST_UNLIKE = 2;

// 12000 as 12,000.
std::string grouped(std::uint64_t number) {
    std::string digits = std::to_string(number);
    for (std::size_t at = digits.size(); at > 3;) digits.insert(at -= 3, ",");
    return digits;
}

std::string moved(const char* name, std::uint64_t edges) {
    if (edges == 0) return fmt::format("{} never moved", name);
    return fmt::format("{} moved {} time{}", name, grouped(edges), edges == 1 ? "" : "s");
}

}  // namespace

Monitor::Monitor(Sink sink, Strictness strictness, Report report, bool has_blank)
    : sink_{std::move(sink)},
      strictness_{strictness},
      report_{std::move(report)},
      has_blank_{has_blank},
      raster_{STRICT_PLACE},
      sample_ps_{video::PERIOD_PS} {}

void Monitor::clock_ps(std::uint64_t period) {
    if (period == sample_ps_) return;
    sample_ps_ = period;
    before_ = {};
    unlock();
}

// The pins' levels last for many clocks: work on runs of equal control levels.
void Monitor::samples(const std::uint32_t* pins, std::size_t count) {
    for (std::size_t i = 0; i < count;) {
        const std::uint32_t control = pins[i] & CONTROL;
        std::size_t end = i + 1;
        while (end < count && (pins[end] & CONTROL) == control) ++end;
        run_of(control, pins + i, static_cast<unsigned>(end - i));
        i = end;
    }
}

void Monitor::run_of(std::uint32_t control, const std::uint32_t* pins, unsigned count) {
    FrameMeter::Begins begins = meter_.run(control, count);
    const bool measured = begins.frame;
    if (strict()) {
        check_.run(control, pins, count);
        const std::uint32_t fell = control_ == ~0u ? 0 : control_ & ~control;
        begins = {(fell & video::HS) != 0, (fell & video::VS) != 0};
        control_ = control;
    }
    if (begins.line) raster_.begin_line();
    if (begins.frame) end_frame();
    if (measured) judge();
    raster_.run(pins, count, control & video::BLANK_N);

    now_ps_ += count * sample_ps_;
    if (!lock_) {
        unlocked_.samples += count;
        unlocked_.coloured += static_cast<std::uint64_t>(
            std::count_if(pins, pins + count, [](auto pin) { return pin & video::RGB; }));
    }
    look_at_the_time();
}

void Monitor::idle(std::uint64_t until_ps) {
    now_ps_ = std::max(now_ps_, until_ps);
    look_at_the_time();
}

void Monitor::end_frame() {
    const bool like_the_lock =
        strict() || (in_range_ && lock_ && meter_.signal().similar_to(*lock_));
    if (raster_.end_frame() && like_the_lock) {
        const bool is_new = raster_.consume_is_new();
        ++frames_;
        new_pictures_ += is_new;
        const Placement& place = raster_.place();
        if (raster_.has_colour_in_porch() && !strict() && report_ &&
            !std::exchange(porch_reported_, true))
            report_("colours before the picture begins" +
                    std::string{has_blank_ ? ", where BLANK_N is high" : ""} +
                    ": a monitor takes what is there for black, so its picture is too dark or has "
                    "false colours");
        if (sink_) sink_({frames_, is_new, raster_.pixels(), place.width, place.height});
    }
    raster_.begin_frame();
}

void Monitor::judge() {
    const VideoSignal& signal = meter_.signal();
    frame_ps_ = now_ps_;
    const bool steady = signal.similar_to(before_);
    before_ = signal;
    if (lock_ && signal.similar_to(*lock_)) {
        unlike_ = 0;
    } else if (!lock_ || ++unlike_ > MOST_UNLIKE) {
        unlock();
        if (steady) lock();
    }
}

void Monitor::lock() {
    lock_ = meter_.signal();
    unlike_ = 0;
    meter_.expect_line(lock_->line_samples);
    const PictureLock found = lock_on(*lock_, sample_ps_, has_blank_);
    in_range_ = found.picture.has_value();
    porch_reported_ = false;
    if (in_range_ && !strict()) {
        raster_ = Raster{*found.picture};
        raster_.begin_line();
        raster_.begin_frame();
    }
    report(found.text);
}

void Monitor::unlock() {
    if (!lock_) return;
    lock_.reset();
    meter_.expect_line(0);
    unlocked_ = {now_ps_, 0, 0, meter_.hs().edges(), meter_.vs().edges(), false};
}

void Monitor::look_at_the_time() {
    if (lock_) {
        if (now_ps_ - frame_ps_ > LONGEST_FRAME) unlock();
    } else if (!unlocked_.reported && now_ps_ - unlocked_.since_ps >= PATIENCE) {
        unlocked_.reported = true;
        report(no_signal());
    }
}

std::string Monitor::no_signal() const {
    if (unlocked_.samples == 0) return "no signal: not one sample, VGA_CLK does not rise";
    const std::uint64_t hs = meter_.hs().edges() - unlocked_.hs_edges,
                        vs = meter_.vs().edges() - unlocked_.vs_edges;
    return fmt::format("{}: {}; {}; VGA_R/G/B were {}", hs && vs ? "no steady signal" : "no signal",
                       moved("HS", hs), moved("VS", vs),
                       unlocked_.coloured == 0
                           ? "always 0"
                           : fmt::format("not 0 in {} samples", grouped(unlocked_.coloured)));
}

void Monitor::report(const std::string& line) {
    signal_ = line;
    if (report_) report_(line);
}

}  // namespace sim
