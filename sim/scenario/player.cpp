#include "sim/scenario/player.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "sim/report/tone.h"
#include "sim/report/whole_file.h"
#include "sim/scenario/seven_segment.h"

namespace sim {

using sc_core::sc_time;
using sc_core::sc_time_stamp;

namespace {

const sc_time look_again{1, sc_core::SC_MS};

sc_time to_sc(SimTime time) { return sc_time::from_value(time.ps); }  // resolution: 1 ps

std::string leds_text(std::uint16_t leds) { return fmt::format("{:010b}", leds); }

}  // namespace

Player::Player(const sc_core::sc_module_name& name, Board& board, Senses& senses,
               const std::vector<Step>& steps, std::filesystem::path out)
    : sc_module{name}, board_{board}, senses_{senses}, steps_{steps}, out_{std::move(out)} {
    SC_HAS_PROCESS(Player);
    SC_THREAD(run);
}

void Player::run() {
    for (; current_ < steps_.size(); ++current_)
        std::visit([this](const auto& step) { act(step); }, steps_[current_].action);
    finished_ = true;
    done_.notify(sc_core::SC_ZERO_TIME);
}

void Player::decide(bool met, std::string detail) {
    const Step& step = steps_[current_];
    results_.push_back(
        {step.text, step.line, sc_time_stamp().to_seconds(), met, std::move(detail)});
}

std::vector<Expectation> Player::results() const {
    std::vector<Expectation> all = results_;
    for (std::size_t i = current_; i < steps_.size(); ++i) {
        const Action& action = steps_[i].action;
        const bool decides = std::holds_alternative<WaitFrame>(action) ||
                             std::holds_alternative<WaitSerial>(action) ||
                             std::holds_alternative<ExpectFrame>(action) ||
                             std::holds_alternative<ExpectTone>(action) ||
                             std::holds_alternative<ExpectSilence>(action) ||
                             std::holds_alternative<ExpectLeds>(action) ||
                             std::holds_alternative<ExpectHex>(action);
        if (decides && !finished_)
            all.push_back({steps_[i].text, steps_[i].line, sc_time_stamp().to_seconds(), false,
                           "the run ended before"});
    }
    return all;
}

template <class Condition>
bool Player::wait_until(const sc_core::sc_event& event, SimTime timeout, Condition met) {
    const sc_time end = sc_time_stamp() + to_sc(timeout);
    while (!met()) {
        if (sc_time_stamp() >= end) return false;
        wait(end - sc_time_stamp(), event);
    }
    return true;
}

template <class Condition>
bool Player::poll_until(SimTime timeout, Condition met) {
    const sc_time end = sc_time_stamp() + to_sc(timeout);
    for (;;) {
        board_.fpga.catch_up();
        if (met()) return true;
        if (sc_time_stamp() >= end) return false;
        wait(std::min(look_again, end - sc_time_stamp()));
    }
}

void Player::act(const Delay& step) { wait(to_sc(step.time)); }

void Player::act(const Press& step) {
    const Controls& c = step.controls;
    board_.hold(c.keypad, c.keys, c.switches);
    wait(to_sc(step.time));
    board_.release(c.keypad, c.keys, c.switches);
}

void Player::act(const Hold& step) {
    board_.hold(step.controls.keypad, step.controls.keys, step.controls.switches);
}

void Player::act(const Release& step) {
    board_.release(step.controls.keypad, step.controls.keys, step.controls.switches);
}

void Player::act(const TypeSerial& step) { board_.type(step.text); }

void Player::act(const SetVoltage& step) { board_.set_voltage(step.channel, step.volts); }
void Player::act(const TypeKeys& step) { board_.type_keys(step.text); }

void Player::act(const WaitFrame& step) {
    const std::uint64_t pictures = senses_.new_pictures;
    const std::uint64_t number =
        step.what == WaitFrame::What::NEXT ? senses_.frames + 1 : step.number;
    const bool met = wait_until(senses_.frame_shown, step.timeout, [&] {
        return step.what == WaitFrame::What::NEXT_SWAP ? senses_.new_pictures > pictures
                                                       : senses_.frames >= number;
    });
    decide(met, fmt::format("{} frames shown, {} of them new pictures", senses_.frames,
                            senses_.new_pictures));
}

void Player::act(const WaitSerial& step) {
    ConsoleText& text = senses_.text;
    if (wait_until(senses_.printed, step.timeout, [&] { return text.take(step.text); }))
        return decide(true, "");
    std::string detail = fmt::format(
        "the console printed {} characters behind the last match, but not that", text.unread());
    if (text.forgotten())
        detail += fmt::format("; the first {} were too old to be looked at", text.forgotten());
    decide(false, detail);
}

void Player::act(const ExpectFrame& step) {
    Image golden;
    try {
        golden = read_golden(step.golden);
    } catch (const std::exception& e) {
        return decide(false, e.what());
    }
    const Image picture = senses_.picture();
    const std::size_t different = differing_pixels(picture, golden);
    const bool met = different <= step.differing_pixels;
    std::string detail = fmt::format("frame {}: {} pixels differ", senses_.frames, different);
    if (!met) {
        const auto folder = out_ / "mismatch";
        const std::string stem =
            fmt::format("line{}_{}", steps_[current_].line, step.golden.stem().string());
        const auto keep = [&](const char* what, const Image& image) {
            const auto path = folder / fmt::format("{}_{}.png", stem, what);
            write_png(path, image);
            return path.string();
        };
        try {
            make_folder(folder);
            const std::string actual = keep("actual", picture);
            const std::string expected = keep("expected", golden);
            const std::string difference = keep("difference", difference_image(golden, picture));
            detail += fmt::format("; see {}, {} and {}", actual, expected, difference);
        } catch (const IoError& e) {
            faults_.push_back(e.what());
        }
    }
    decide(met, detail);
}

void Player::act(const ExpectTone& step) {
    const std::uint64_t from = senses_.samples;
    Tone best;
    const SimTime whole{step.timeout.ps + step.time.ps};
    const bool met = poll_until(whole, [&] {
        const auto window = static_cast<std::uint64_t>(
            std::llround(static_cast<double>(step.time.ps) * 1e-12 * senses_.rate_hz));
        if (window == 0 || senses_.samples - from < window) return false;
        const auto samples = senses_.last_samples(window);
        const Tone tone = analyse_tone(samples, senses_.rate_hz);
        if (tone.level_dbfs > best.level_dbfs) best = tone;
        if (!is_tone(samples, senses_.rate_hz, step.hz, step.within)) return false;
        best = tone;
        return true;
    });
    decide(met, best.hz == 0 ? "silence"
                             : fmt::format("{:.1f} Hz at {:.1f} dBFS, {:.0f} % of the energy",
                                           best.hz, best.level_dbfs, best.share * 100));
}

void Player::act(const ExpectSilence& step) {
    const std::uint64_t from = senses_.samples;
    wait(to_sc(step.time));
    board_.fpga.catch_up();
    const auto samples = senses_.last_samples(senses_.samples - from);
    const auto sound = std::find_if(samples.begin(), samples.end(), [](auto s) { return s != 0; });
    const bool heard = sound != samples.end();
    decide(!heard && !samples.empty(),
           samples.empty() ? "no samples were played"
           : heard
               ? fmt::format("sound after {:.3f} ms",
                             1e3 * static_cast<double>(sound - samples.begin()) / senses_.rate_hz)
               : "");
}

void Player::act(const ExpectLeds& step) {
    const bool met =
        poll_until(step.timeout, [&] { return board_.fpga.fabric().ledr() == step.leds; });
    decide(met, "LEDR shows " + leds_text(board_.fpga.fabric().ledr()));
}

void Player::act(const ExpectHex& step) {
    std::string shown;
    const auto as_expected = [&] {
        const std::uint64_t lit = ~board_.fpga.fabric().hex_n();
        HexSegments segments{};
        for (unsigned i = 0; i < HEX_DIGITS; ++i)
            segments[i] = static_cast<std::uint8_t>(lit >> (7 * i) & 0x7f);
        shown = hex_text(segments, step.text);
        return shown == step.text;
    };
    const bool met = poll_until(step.timeout, as_expected);
    decide(met, "HEX shows \"" + shown + "\"");
}

void Player::act(const TakeScreenshot& step) {
    try {
        const auto path = out_ / step.save_to;
        make_folder(path.parent_path());
        write_png(path, senses_.picture());
    } catch (const IoError& e) {
        faults_.push_back(e.what());
    }
}

}  // namespace sim
