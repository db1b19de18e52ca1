#include "sim/live/live_player.h"

#include <algorithm>
#include <iterator>
#include <string_view>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "sim/files/whole_file.h"
#include "sim/scenario/continued.h"
#include "sim/scenario/step_table.h"
#include "sim/text/seconds.h"

namespace sim::live {

using sc_core::sc_time;
using sc_core::sc_time_stamp;

namespace {

const sc_time tick{1, sc_core::SC_MS}, between_clocks{3, sc_core::SC_NS};
constexpr int MOST_LEVELS = 16;  // of a message; thousands would need more stack than there is
constexpr auto STATUS_PERIOD = std::chrono::milliseconds{250};
constexpr double MOST_BEHIND_S = 0.1;  // which is made up for; what is more is given up

// The message of the board: what it has, and all LEDs, digits and switches that a board can have.
nlohmann::json as_json(const BoardParts& board) {
    nlohmann::json leds = nlohmann::json::array(), switches = nlohmann::json::array();
    for (unsigned n = 0; n < LEDS; ++n) leds.push_back(wire_of(WireGroup::LAMPS, n));
    for (unsigned n = 0; n < SWITCHES; ++n) switches.push_back(wire_of(WireGroup::SWITCHES, n));
    return {{"board",
             {{"name", board.name},
              {"wires", board.wires},
              {"names", board.names},
              {"digits", DIGITS},
              {"leds", leds},
              {"switches", switches}}}};
}

double wall_seconds(std::chrono::steady_clock::duration d) {
    return std::chrono::duration<double>(d).count();
}

// A page must not make de1sim open a file.
bool opens_file(const std::string& step) {
    for (const StepForm& form : step_forms())
        if (step == form.name)
            return std::any_of(form.fields.begin(), form.fields.end(),
                               [](const Field& field) { return field.type.is_opened; });
    return false;
}

void add_delay(std::vector<std::string>& steps, sc_time time) {
    static const sc_time longest = sc_time::from_value(MAX_SIM_TIME.ps);
    for (; time > longest; time -= longest) steps.push_back("delay: " + to_string(MAX_SIM_TIME));
    if (time > sc_core::SC_ZERO_TIME) steps.push_back("delay: " + to_string(SimTime{time.value()}));
}

}  // namespace

LivePlayer::LivePlayer(const sc_core::sc_module_name& name, ScenarioRunner& runner, LiveView& view,
                       PartsView& parts, Inside& inside, Wire& wire, const RunPlan& plan)
    : sc_module{name},
      runner_{runner},
      view_{view},
      parts_{parts},
      inside_{inside},
      wire_{wire},
      plan_{plan},
      scenario_{plan.scenario},
      seed_{plan.seed},
      out_{plan.description.outputs.out},
      steps_{plan.scenario},
      waves_{plan.description} {
    SC_HAS_PROCESS(LivePlayer);
    SC_THREAD(run);
}

void LivePlayer::run() {
    wire_.send(Kind::TEXT, as_json(scenario_.board).dump());
    set_pace(1, false);
    wait(between_clocks);
    handle_messages();  // that time stands from the beginning
    keep_pace();
    for (;;) {
        wait(tick);
        wait(sc_core::SC_ZERO_TIME);  // as in ScenarioRunner::wait()
        inside_.settle_lamps();
        view_.flush();
        parts_.flush(sc_time_stamp().value(), false);
        for (const std::string& line : inside_.new_violations()) send_event("violation", line);
        if (pause_at_frame_ != 0 && view_.frames() >= pause_at_frame_) set_pace(speed_, true);
        if (exact_run_ && exact_run_->over(counts(), sc_time_stamp())) end_exact_run();
        handle_messages();
        look_at_waves();
        keep_pace();
        if (left_) sc_core::sc_pause();
    }
}

// ---- Time ----

void LivePlayer::set_pace(double speed, bool paused) {
    speed_ = speed;
    paused_ = paused;
    pause_at_frame_ = 0;
    since_ = Clock::now();
    since_sim_ = sc_time_stamp();
    send_status();
}

ExactRun::Counts LivePlayer::counts() const {
    return {view_.frames(),     view_.new_pictures(), view_.printed(),
            view_.lamps_seen(), view_.pins_seen(),    runner_.finished()};
}

void LivePlayer::begin_exact_run(const nlohmann::json& order) {
    if (exact_run_) throw std::runtime_error{"run: expected the end of the run before, \"ran\""};
    view_.leave_nothing_out();
    exact_run_.emplace(order, counts(), sc_time_stamp());
    if (exact_run_->over(counts(), sc_time_stamp())) return end_exact_run();
    paused_ = false;
    since_ = Clock::now();
    since_sim_ = sc_time_stamp();
}

void LivePlayer::end_exact_run() {
    view_.flush();
    parts_.flush(sc_time_stamp().value(), true);
    const nlohmann::json ran{{"time", seconds(sc_time_stamp())},
                             {"frames", view_.frames()},
                             {"pictures", view_.new_pictures()},
                             {"picture", view_.sent_frame()},
                             {"met", exact_run_->met(counts())}};
    exact_run_.reset();
    paused_ = true;
    wire_.send(Kind::TEXT, nlohmann::json{{"ran", ran}}.dump());
}

// Waits for the other clock, and takes what arrives meanwhile.
void LivePlayer::keep_pace() {
    while (!left_) {
        const auto now = Clock::now();
        if (now - status_at_ >= STATUS_PERIOD) send_status();
        int wait_ms = 50;
        if (!paused_) {
            if (speed_ == 0) return;
            const double ahead =
                seconds(sc_time_stamp() - since_sim_) / speed_ - wall_seconds(now - since_);
            if (ahead < -MOST_BEHIND_S) {
                since_ = now;
                since_sim_ = sc_time_stamp();
            }
            if (ahead < 0.001) return;
            wait_ms = std::min(wait_ms, static_cast<int>(ahead * 1000));
        }
        if (!wire_.poll(wait_ms)) left_ = true;
        handle_messages();
        look_at_waves();
    }
}

void LivePlayer::send_status() {
    const auto now = Clock::now();
    const double passed = wall_seconds(now - status_at_);
    nlohmann::json status{
        {"time", seconds(sc_time_stamp())},
        {"speed", speed_},
        {"paused", paused_},
        {"frames", view_.frames()},
        {"pictures", view_.new_pictures()},
        {"steps", played_.size()},
        {"factor", seconds(sc_time_stamp() - status_at_sim_) / std::max(passed, 1e-3)}};
    status_at_ = now;
    status_at_sim_ = sc_time_stamp();
    wire_.send(Kind::TEXT, nlohmann::json{{"status", status}}.dump());
    wire_.send(Kind::TEXT, nlohmann::json{{"inside", inside_.look()}}.dump());
}

// ---- Messages ----

void LivePlayer::send_event(const char* name, const std::string& text) {
    wire_.send(Kind::TEXT, nlohmann::json{{name, text}}.dump(
                               -1, ' ', false, nlohmann::json::error_handler_t::replace));
}

void LivePlayer::handle_messages() {
    if (!wire_.poll(0)) left_ = true;
    while (!left_) {
        const auto message = wire_.receive();
        if (!message) return;
        try {
            handle(message->bytes);
        } catch (const std::exception& error) {
            send_event("error", error.what());
        }
    }
}

void LivePlayer::handle(const std::string& text) {
    const auto look = [](int level, nlohmann::json::parse_event_t, nlohmann::json&) {
        if (level > MOST_LEVELS)
            throw std::runtime_error{fmt::format(
                "expected at most {} levels of lists and objects, got more", MOST_LEVELS)};
        return true;
    };
    const auto message = nlohmann::json::parse(text, look, false);
    if (!message.is_object() || message.size() != 1)
        throw std::runtime_error{"expected an object with one member, such as {\"pause\": true}"};
    const std::string& name = message.begin().key();
    const auto& value = message.begin().value();
    if (name == "step" && value.is_object() && value.size() == 1) {
        play(value.begin().key(), value.dump());
    } else if (name == "pause" && value.is_boolean()) {
        set_pace(speed_, value.get<bool>());
    } else if (name == "speed" && value.is_number() && value >= 0 && value <= 1000) {
        set_pace(value.get<double>(), paused_);
    } else if (name == "frame" && value.is_number_unsigned() && value > 0 && value <= 3600) {
        set_pace(speed_, false);
        pause_at_frame_ = view_.frames() + value.get<std::uint64_t>();
    } else if (name == "run") {
        begin_exact_run(value);
    } else if (name == "mark" && value == true) {
        mark();
    } else if (name == "save" && value == true) {
        save();
    } else if (name == "waves") {
        ask_for_waves(value);
    } else if (name == "quit" && value == true) {
        left_ = true;
    } else {
        throw std::runtime_error{
            "expected step, pause, speed from 0 to 1000, frame from 1 to 3600, run, mark, save, "
            "waves or quit, got " +
            text.substr(0, 100)};
    }
}

void LivePlayer::play(const std::string& name, const std::string& text) {
    if (opens_file(name)) throw std::runtime_error{"not played live: " + name};
    if (!runner_.finished())
        throw std::runtime_error{"the scenario's steps still play; wait for their end"};
    const ScenarioStep step = steps_.read(text);
    if (const std::string missing = missing_for(plan_, *step.step); !missing.empty())
        throw std::runtime_error{missing};
    if (step.step->decides()) throw std::runtime_error{"not played live: " + name};
    const bool at_once = name == "release" && !paused_ && !exact_run_ && !played_.empty() &&
                         played_.back().begin == sc_time_stamp();
    if (at_once) {  // a click that was shorter than a look at the messages is one that long
        wait(tick);
        wait(sc_core::SC_ZERO_TIME);
    }
    Played played{sc_time_stamp(), {}, text};
    step.step->play(runner_.control());
    played.end = sc_time_stamp();
    played_.push_back(std::move(played));
}

// ---- The record ----

void LivePlayer::mark() {
    const auto name = fmt::format("live-{}.png", ++marks_);
    write_png(out_ / name, runner_.control().observations().picture());
    const auto now = sc_time_stamp();
    played_.push_back({now, now, fmt::format("expect-frame: {{equals: {}}}", name)});
    send_event("marked", (out_ / name).string());
}

// A scenario that plays all of this again, up to now.
std::string LivePlayer::record() {
    if (!runner_.finished())
        throw std::runtime_error{
            "cannot save: the scenario's steps still play; wait for their end"};
    std::vector<std::string> steps;
    sc_time now = runner_.finished_at();
    for (const Played& played : played_) {
        add_delay(steps, played.begin - now);
        steps.push_back(played.step);
        now = played.end;
    }
    add_delay(steps, sc_time_stamp() - now);
    Scenario nothing;
    nothing.text = "name: live\nversion: 1\n";
    return "# Recorded by de1sim live: play it with the options of that run.\n" +
           continued(scenario_.file.empty() ? nothing : scenario_, seed_, out_, steps);
}

void LivePlayer::save() {
    const std::string text = record();
    const auto file = out_ / "live.yaml";
    write_whole_file(file, text);
    wire_.send(Kind::TEXT,
               nlohmann::json{{"saved", {{"file", file.string()}, {"text", text}}}}.dump());
}

// ---- Waveforms ----

void LivePlayer::ask_for_waves(const nlohmann::json& when) {
    const bool last = when.is_object() && when.size() == 1 && when.contains("last");
    const bool next = when.is_object() && when.size() == 1 && when.contains("next");
    const auto time = (last || next) && when.begin().value().is_string()
                          ? SimTime::parse(when.begin().value().get<std::string>())
                          : std::nullopt;
    constexpr SimTime MOST{1'000'000'000'000};
    if (!time || time->ps == 0 || MOST < *time)
        throw std::runtime_error{
            "expected waves with last or next and a time of up to 1s, such as {\"last\": "
            "\"20ms\"}"};
    const sc_time length = sc_time::from_value(time->ps), now = sc_time_stamp();
    if (last)
        wanted_ = {now > length ? now - length : sc_core::SC_ZERO_TIME, now};
    else
        wanted_ = {now, now + length};
    look_at_waves();
}

void LivePlayer::look_at_waves() {
    if (const auto done = waves_.done())
        done->file.empty() ? send_event("error", "no waveforms: " + done->problem)
                           : send_event("waves", done->file);
    if (!wanted_ || sc_time_stamp() < wanted_->to) return;
    const Part part = *wanted_;
    wanted_.reset();
    waves_.begin(record(), SimTime{part.from.value()}, SimTime{part.to.value()});
}

}  // namespace sim::live
