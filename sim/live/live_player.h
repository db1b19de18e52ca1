// live_player.h - the person at a live board: steps that arrive over the wire, and the watch.
//
// Once per simulated millisecond, 3 ns after its beginning, where no clock of the board ticks, the
// messages that have arrived are carried out and the run is held back to the speed that was chosen.
// While time goes on, what is let go of at the time at which it was pressed is let go of a
// millisecond later, or the board would not see it.  Each step is kept with its time: the scenario
// that save() writes has them at the same times, so that it plays to the same pictures and the same
// sound.
#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "sim/live/exact_run.h"
#include "sim/live/inside.h"
#include "sim/live/live_view.h"
#include "sim/live/parts_view.h"
#include "sim/live/waves.h"
#include "sim/run/plan.h"
#include "sim/scenario/scenario_runner.h"
#include "sim/scenario/step_reader.h"

#include <systemc>

namespace sim::live {

class LivePlayer : public sc_core::sc_module {
public:
    // Steps go through `runner`, whose own must be over.  `plan`: with which the run began.
    LivePlayer(const sc_core::sc_module_name& name, ScenarioRunner& runner, LiveView& view,
               PartsView& parts, Inside& inside, Wire& wire, const RunPlan& plan);

    bool left() const { return left_; }  // the server is gone, or has asked for the end
    // The run has ended: what is left of it waits for nobody's message.
    void leave() { left_ = true; }

private:
    struct Played {
        sc_core::sc_time begin, end;
        std::string step;
    };
    using Clock = std::chrono::steady_clock;

    void run();
    void keep_pace();
    void handle_messages();
    void handle(const std::string& text);
    void play(const std::string& name, const std::string& text);
    void set_pace(double speed, bool paused);
    void begin_exact_run(const nlohmann::json& order);
    void end_exact_run();
    ExactRun::Counts counts() const;
    void send_event(const char* name, const std::string& text);
    void send_status();
    void mark();
    std::string record();
    void save();
    void ask_for_waves(const nlohmann::json& when);
    void look_at_waves();

    ScenarioRunner& runner_;
    LiveView& view_;
    PartsView& parts_;
    Inside& inside_;
    Wire& wire_;
    const RunPlan& plan_;
    const Scenario& scenario_;
    const std::uint64_t seed_;
    const std::filesystem::path out_;
    StepReader steps_;
    Waves waves_;

    double speed_ = 1;  // simulated seconds per second; 0: as fast as it goes
    bool paused_ = false, left_ = false;
    std::uint64_t pause_at_frame_ = 0;
    std::optional<ExactRun> exact_run_;           // which is under way
    Clock::time_point since_, status_at_;         // when pace and status were last set
    sc_core::sc_time since_sim_, status_at_sim_;  // in simulated time
    std::vector<Played> played_;
    unsigned marks_ = 0;
    struct Part {
        sc_core::sc_time from, to;
    };
    std::optional<Part> wanted_;  // waveforms of it, as soon as it has been played
};

}  // namespace sim::live
