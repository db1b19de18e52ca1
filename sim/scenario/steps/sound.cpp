// sound.cpp - expect-tone, expect-silence: ears at the line output
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim/board/tone.h"
#include "sim/scenario/board_control.h"
#include "sim/scenario/static_checks.h"
#include "sim/scenario/step_form.h"
#include "sim/text/words.h"

namespace sim {

namespace {

using namespace value_types;

// ---- expect-tone ----

const ValueType PERCENT = percent("a percentage such as 3%, from 0.01% to 50%", 0.01, 50);

class ExpectTone : public Claim {
public:
    explicit ExpectTone(const Values& v)
        : hz_{v.get<double>("hz")},
          within_{v.get<double>("within")},
          time_{v.get<SimTime>("for")},
          timeout_{v.get<SimTime>("timeout")} {}

    void check(StaticChecks& checks) const override {
        checks.need_on_board("AUD_DACDAT", "LINE OUT");
    }
    std::string describe() const override {
        return fmt::format("expect a tone of {} Hz, give or take {:.6g}%, for {}{}", hz_,
                           within_ * 100, to_string(time_), within(timeout_));
    }
    SimTime least() const override { return time_; }
    Verdict decide(BoardControl& board) const override {
        const std::uint64_t from = board.observations().samples;
        Tone best;
        const SimTime whole{timeout_.ps + time_.ps};
        const bool met = board.wait_until(BoardControl::Each::MILLISECOND, whole, [&] {
            const Observations& ears = board.observations();
            const auto window = static_cast<std::uint64_t>(
                std::llround(static_cast<double>(time_.ps) * 1e-12 * ears.rate_hz));
            if (window == 0 || ears.samples - from < window) return false;
            const auto samples = ears.last_samples(window);
            const Tone tone = analyse_tone(samples, ears.rate_hz);
            const bool is_it = is_tone(samples, ears.rate_hz, hz_, within_);
            if (is_it || tone.level_dbfs > best.level_dbfs) best = tone;
            return is_it;
        });
        return {met, best.hz == 0 ? "silence"
                                  : fmt::format("{:.1f} Hz at {:.1f} dBFS, {:.0f} % of the energy",
                                                best.hz, best.level_dbfs, best.share * 100)};
    }

private:
    double hz_;
    double within_;  // fraction: 0.03 for 3%
    SimTime time_;   // it begins within `timeout` and lasts so long
    SimTime timeout_;
};

// ---- expect-silence ----

class ExpectSilence : public Claim {
public:
    explicit ExpectSilence(const Values& v) : time_{v.get<SimTime>("for")} {}

    void check(StaticChecks& checks) const override {
        checks.need_on_board("AUD_DACDAT", "LINE OUT");
    }
    std::string describe() const override { return "expect silence for " + to_string(time_); }
    SimTime least() const override { return time_; }
    Verdict decide(BoardControl& board) const override {
        const std::uint64_t from = board.observations().samples;
        board.wait(time_);
        const Observations& ears = board.observations();
        const auto samples = ears.last_samples(ears.samples - from);
        if (samples.empty()) return {false, "no samples were played"};
        const auto sound =
            std::find_if(samples.begin(), samples.end(), [](auto s) { return s != 0; });
        if (sound == samples.end()) return {true, ""};
        return {false,
                fmt::format("sound after {:.3f} ms",
                            1e3 * static_cast<double>(sound - samples.begin()) / ears.rate_hz)};
    }

private:
    SimTime time_;
};

}  // namespace

namespace steps {

std::vector<StepForm> sound() {
    return {
        {"expect-tone",
         "Listen for a tone at the line output.",
         Notation::MAP,
         {},
         {{"hz", HERTZ, Need::REQUIRED, "", "Its frequency in hertz."},
          {"within", PERCENT, Need::OPTIONAL, "3%", "How far the frequency may be off."},
          {"for", SOME_TIME, Need::OPTIONAL, "100ms", "How long the tone lasts at least."},
          {"timeout", TIME, Need::OPTIONAL, "1s", "How long it may take until the tone begins."}},
         make<ExpectTone>},
        {"expect-silence",
         "Listen to the line output and hear nothing.",
         Notation::MAP,
         {},
         {{"for", SOME_TIME, Need::REQUIRED, "", "How long."}},
         make<ExpectSilence>},
    };
}

}  // namespace steps

}  // namespace sim
