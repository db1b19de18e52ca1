#include "sim/hps/spi_wires.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace sim {

namespace {

struct SpiReleased {};

}  // namespace

// ---- A master ----

SpiMasterWires::SpiMasterWires(const sc_core::sc_module_name& module_name, FabricWires wires,
                               std::function<void()> done)
    : sc_module{module_name}, wires_{std::move(wires)}, done_{std::move(done)} {
    SC_HAS_PROCESS(SpiMasterWires);
    SC_THREAD(run);
}

void SpiMasterWires::send(const Frame& frame) {
    next_ = frame;
    begin_.notify(sc_core::SC_ZERO_TIME);
}

void SpiMasterWires::release(bool idle_high) {
    next_.reset();
    idle_high_ = idle_high;
    released_.notify(sc_core::SC_ZERO_TIME);
}

void SpiMasterWires::run() {
    for (;;) {
        try {
            if (!next_) wait(begin_ | released_);
            if (!next_) throw SpiReleased{};
            frame_ = *std::exchange(next_, std::nullopt);
            idle_high_ = frame_.format.idle_high;
            pass_until(free_ps_);
            run_frame();
            done_();
            if (frame_.format.second_edge && next_) continue;
            pass_until(sc_core::sc_time_stamp().value() + frame_.period_ps / 2);
        } catch (const SpiReleased&) {
        }
        put(idle_high_, false);
        free_ps_ = sc_core::sc_time_stamp().value() + frame_.period_ps / 2;
    }
}

void SpiMasterWires::run_frame() {
    struct Step {
        std::uint64_t time_ps;
        enum Kind { SAMPLE, EDGE } kind;
        unsigned bit;   // of the frame, from the first on
        bool is_first;  // the edge is the first of the bit
    };
    const auto& [format, period_ps, delay_ps, slaves, value] = frame_;
    const std::uint64_t begin_ps = sc_core::sc_time_stamp().value();
    std::vector<Step> steps;
    for (unsigned bit = 0; bit < format.bits; ++bit) {
        const std::uint64_t second_ps = begin_ps + (bit + 1) * period_ps,
                            first_ps = second_ps - period_ps / 2;
        steps.push_back({first_ps, Step::EDGE, bit, true});
        steps.push_back({second_ps, Step::EDGE, bit, false});
        const std::uint64_t sample_ps = format.second_edge ? second_ps : first_ps;
        steps.push_back({sample_ps + delay_ps, Step::SAMPLE, bit, false});
    }
    std::sort(steps.begin(), steps.end(), [](const Step& a, const Step& b) {
        return a.time_ps != b.time_ps ? a.time_ps < b.time_ps : a.kind < b.kind;
    });
    const auto level_of = [&, bits = format.bits, sent = value](unsigned bit) {
        return (sent >> (bits - 1 - bit) & 1) != 0;
    };
    received_ = 0;
    if (!format.second_edge) txd_ = level_of(0);
    put(format.idle_high, true);
    for (const Step& step : steps) {
        pass_until(step.time_ps);
        if (step.kind == Step::SAMPLE) {
            wires_.catch_up(sc_core::sc_time_stamp());
            received_ = received_ << 1 | static_cast<std::uint32_t>(rxd_);
            continue;
        }
        const bool moves_data = step.is_first == format.second_edge;
        const unsigned bit = step.bit + (format.second_edge ? 0 : 1);
        if (moves_data && bit < format.bits) txd_ = level_of(bit);
        put(step.is_first != format.idle_high, true);
    }
}

void SpiMasterWires::pass_until(std::uint64_t time_ps) {
    const std::uint64_t now_ps = sc_core::sc_time_stamp().value();
    if (time_ps <= now_ps) return;
    wait(sc_core::sc_time::from_value(time_ps - now_ps), released_);
    if (released_.triggered()) throw SpiReleased{};
}

void SpiMasterWires::put(bool sclk, bool is_selected) {
    const std::uint64_t off = is_selected ? 0 : 1, not_selected = ~frame_.slaves & 0xF;
    wires_.drive(
        (txd_ ? 1u : 0u) | (sclk ? 2u : 0u) | off << 2 | (is_selected ? not_selected : 0xF) << 3,
        sc_core::sc_time_stamp());
}

// ---- A slave ----

void SpiSlaveWires::moved(bool rxd, bool is_selected, bool sclk, const SpiFormat& format) {
    const auto put = [&] { frames_.put(out_ >> (format.bits - 1 - done_) & 1, is_selected_); };
    const bool begins = is_selected && !is_selected_, ends = !is_selected && is_selected_,
               is_edge = sclk != sclk_ && is_selected && is_selected_;
    is_selected_ = is_selected;
    sclk_ = sclk;
    if (begins) {
        done_ = 0;
        out_ = frames_.next();
        put();
    }
    if (ends) {
        done_ = 0;
        put();
    }
    if (!is_edge) return;
    const bool is_first = sclk != format.idle_high;
    if (is_first == format.second_edge) {
        if (done_ == 0) out_ = frames_.next();
        return put();
    }
    if (done_ == 0) frames_.begun();
    in_ = in_ << 1 | static_cast<std::uint32_t>(rxd);
    if (++done_ < format.bits) return;
    frames_.received(in_ & ((1u << format.bits) - 1));
    done_ = 0;
}

}  // namespace sim
