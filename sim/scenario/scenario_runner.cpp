#include "sim/scenario/scenario_runner.h"

#include <algorithm>

#include "sim/board/serial_terminal.h"
#include "sim/files/whole_file.h"
#include "sim/text/seconds.h"

namespace sim {

using sc_core::sc_time;
using sc_core::sc_time_stamp;

namespace {

const sc_time millisecond{1, sc_core::SC_MS};

sc_time to_sc(SimTime time) { return sc_time::from_value(time.ps); }  // resolution: 1 ps

}  // namespace

ScenarioRunner::ScenarioRunner(const sc_core::sc_module_name& name, Board& board,
                               Observations& observations, const std::vector<ScenarioStep>& steps,
                               std::filesystem::path out)
    : sc_module{name},
      board_{board},
      observations_{observations},
      steps_{steps},
      out_{std::move(out)} {
    observations_.frame_shown = [this] { perceive(frame_shown_); };
    observations_.printed = [this] { perceive(printed_); };
    board_.parts.for_each<SerialTerminal>(
        [this](const std::string& part, SerialTerminal& terminal) {
            terminal.heard = [this, part, &text = terminals_[part]](char byte) {
                text.print(byte);
                on_terminal(part, byte);
                perceive(printed_);
            };
        });
    SC_HAS_PROCESS(ScenarioRunner);
    SC_THREAD(run);
}

void ScenarioRunner::run() {
    for (; current_ < steps_.size(); ++current_) {
        const ScenarioStep& step = steps_[current_];
        const double from_s = seconds(sc_time_stamp());
        played_.push_back({from_s, from_s, {}});
        if (auto verdict = step.step->play(*this))
            results_.push_back(expectation(step, *std::move(verdict)));
        played_.back().to_s = seconds(sc_time_stamp());
        on_step();
    }
    finished_ = true;
    finished_at_ = sc_time_stamp();
    done_.notify(sc_core::SC_ZERO_TIME);
}

Expectation ScenarioRunner::expectation(const ScenarioStep& step, Verdict verdict) {
    return {step.text, step.line, seconds(sc_time_stamp()), verdict.met, std::move(verdict.detail)};
}

std::vector<Expectation> ScenarioRunner::results() const {
    std::vector<Expectation> all = results_;
    for (std::size_t i = current_; i < steps_.size(); ++i)
        if (steps_[i].step->decides())
            all.push_back(expectation(steps_[i], {false, "the run ended before"}));
    return all;
}

// ---- Time ----

// What earlier steps still do at that instant, such as letting a key go, comes before the next
// step.  LivePlayer has the same order, so that what it recorded plays the same again.
void ScenarioRunner::wait(SimTime time) {
    sc_module::wait(to_sc(time));
    sc_module::wait(sc_core::SC_ZERO_TIME);
}

bool ScenarioRunner::wait_until(Each each, SimTime timeout, const std::function<bool()>& met) {
    const sc_time end = sc_time_stamp() + to_sc(timeout);
    for (;;) {
        if (met()) return true;
        if (sc_time_stamp() >= end) return false;
        const sc_time rest = end - sc_time_stamp();
        switch (each) {
            case Each::FRAME: sc_module::wait(rest, frame_shown_); break;
            case Each::CHARACTER: sc_module::wait(rest, printed_); break;
            case Each::MILLISECOND: sc_module::wait(std::min(millisecond, rest)); break;
        }
        while (perceived_ps_ > sc_time_stamp().value())
            sc_module::wait(sc_time::from_value(perceived_ps_) - sc_time_stamp());
    }
}

// A processor that runs ahead may have come to it before SystemC has.
void ScenarioRunner::perceive(sc_core::sc_event& what) {
    perceived_ps_ = std::max(perceived_ps_, board_.chip().time_ps());
    what.notify(sc_core::SC_ZERO_TIME);
}

// ---- Hands ----

void ScenarioRunner::before_press(const std::string& control) {
    if (hands_.has_just_let_go(control)) sc_module::wait(Hands::pause());
}

void ScenarioRunner::press(const std::string& control, std::function<void()> action) {
    before_press(control);
    board_.act(std::move(action));
}
void ScenarioRunner::let_go(const std::string& control, std::function<void()> action) {
    board_.act(std::move(action));
    hands_.let_go(control);
}
void ScenarioRunner::hold(const Controls& c, SimTime bounce) {
    for (const unsigned number : control_numbers(c)) before_press(control_name(number));
    board_.hold(c.keypad, c.keys, c.switches, bounce.ps);
}
void ScenarioRunner::release(const Controls& c, SimTime bounce) {
    board_.release(c.keypad, c.keys, c.switches, bounce.ps);
    for (const unsigned number : control_numbers(c)) hands_.let_go(control_name(number));
}
void ScenarioRunner::drive_pins(const HeaderMasks& pins, PinLevel level) {
    board_.drive_pins(pins, level);
}
void ScenarioRunner::type_serial(const std::string& text, std::optional<SerialLine> to) {
    board_.type(text, to);
}

// ---- Eyes and ears ----

Observations& ScenarioRunner::observations() {
    catch_up();
    return observations_;
}

ConsoleText& ScenarioRunner::terminal(const std::string& part) {
    catch_up();
    return terminals_.at(part);
}

std::uint32_t ScenarioRunner::ledr() {
    catch_up();
    return board_.lamps().ledr;
}

HexSegments ScenarioRunner::hex() {
    catch_up();
    return segments_of(board_.lamps().hex);
}

bool ScenarioRunner::hps_led() {
    catch_up();
    return board_.lamps().hps_led;
}

HeaderMasks ScenarioRunner::header_levels() {
    catch_up();
    HeaderMasks levels{};
    for (unsigned n = 0; n < HEADERS; ++n) levels[n] = board_.lamps().gpio[n].levels;
    return levels;
}

// ---- The output folder ----

bool ScenarioRunner::save(const std::filesystem::path& path, const Image& image) {
    try {
        make_folder(path.parent_path());
        write_png(path, image);
        if (!played_.empty()) played_.back().saved.push_back(path);
        return true;
    } catch (const IoError& e) {
        faults_.push_back(e.what());
        return false;
    }
}

bool ScenarioRunner::renew(const std::filesystem::path& golden, const Image& picture) {
    if (!renews_goldens) return false;
    try {
        write_png(golden, picture);
        return true;
    } catch (const IoError& e) {
        faults_.push_back(e.what());
        return false;
    }
}

}  // namespace sim
