// scenario_runner.h - carries out a scenario's steps on the board, in simulated time
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "sim/board/board.h"
#include "sim/report/report.h"
#include "sim/scenario/board_control.h"
#include "sim/scenario/scenario.h"

#include <systemc>

namespace sim {

// A person who presses a control again lets go of it for a while.
//
// A press that follows the release of the same control at the same instant comes 50 ms later.  With
// time between them, however short, they are where the scenario has them.
class Hands {
public:
    static sc_core::sc_time pause() { return {50, sc_core::SC_MS}; }

    // Controls by any names.
    void let_go(const std::string& control) { let_go_[control] = sc_core::sc_time_stamp(); }
    bool has_just_let_go(const std::string& control) const {
        const auto found = let_go_.find(control);
        return found != let_go_.end() && found->second == sc_core::sc_time_stamp();
    }

private:
    std::map<std::string, sc_core::sc_time> let_go_;  // when
};

class ScenarioRunner : public sc_core::sc_module, private BoardControl {
public:
    // Runs through `steps` from time 0, then notifies done().  Pictures go into `out`.
    ScenarioRunner(const sc_core::sc_module_name& name, Board& board, Observations& observations,
                   const std::vector<ScenarioStep>& steps, std::filesystem::path out);

    const sc_core::sc_event& done() const { return done_; }

    // For steps that come later than the scenario's, from a process of SystemC.
    BoardControl& control() { return *this; }
    bool finished() const { return finished_; }
    const sc_core::sc_time& finished_at() const { return finished_at_; }

    // One for each claim, in order.  Claims that the run's end cut off are included as not met.
    std::vector<Expectation> results() const;

    // When each step that has begun did so and was done, and the pictures that it saved.
    struct Played {
        double from_s, to_s;
        std::vector<std::filesystem::path> saved;
    };
    const std::vector<Played>& played() const { return played_; }
    bool renews_goldens = false;            // that differ
    std::function<void()> on_step = [] {};  // called when one is done
    // What the terminals of the parts show, as it comes.
    std::function<void(const std::string& part, char)> on_terminal = [](const std::string&, char) {
    };

    // Why a picture could not be written; empty if all could.
    const std::vector<std::string>& faults() const { return faults_; }

private:
    void run();
    void perceive(sc_core::sc_event& what);
    void before_press(const std::string& control);
    static Expectation expectation(const ScenarioStep& step, Verdict verdict);

    void wait(SimTime time) override;
    bool wait_until(Each each, SimTime timeout, const std::function<bool()>& met) override;
    void hold(const Controls& controls, SimTime bounce) override;
    void release(const Controls& controls, SimTime bounce) override;
    void drive_pins(const HeaderMasks& pins, PinLevel level) override;
    void type_serial(const std::string& text, std::optional<SerialLine> to) override;
    Observations& observations() override;
    ConsoleText& terminal(const std::string& part) override;
    std::uint32_t ledr() override;
    HexSegments hex() override;
    bool hps_led() override;
    HeaderMasks header_levels() override;
    void act(std::function<void()> action) override { board_.act(std::move(action)); }
    void press(const std::string& control, std::function<void()> action) override;
    void let_go(const std::string& control, std::function<void()> action) override;
    void catch_up() override { board_.chip().catch_up(); }
    std::uint64_t now_ps() const override { return sc_core::sc_time_stamp().value(); }
    Part& any_part(const std::string& name) override { return board_.parts.get(name); }
    const std::filesystem::path& folder() const override { return out_; }
    bool save(const std::filesystem::path& path, const Image& image) override;
    bool renew(const std::filesystem::path& golden, const Image& picture) override;

    Board& board_;
    Hands hands_;
    Observations& observations_;
    std::map<std::string, ConsoleText> terminals_;  // of the parts
    const std::vector<ScenarioStep>& steps_;
    const std::filesystem::path out_;
    sc_core::sc_event frame_shown_, printed_;
    std::uint64_t perceived_ps_ = 0;  // when the last of them came
    std::size_t current_ = 0;
    std::vector<Expectation> results_;
    std::vector<Played> played_;
    std::vector<std::string> faults_;
    bool finished_ = false;
    sc_core::sc_time finished_at_;
    sc_core::sc_event done_;
};

}  // namespace sim
