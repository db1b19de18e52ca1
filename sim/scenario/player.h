// player.h - the person in front of the board: carries out a scenario's steps in simulated time.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sim/board/board.h"
#include "sim/report/report.h"
#include "sim/scenario/scenario.h"
#include "sim/scenario/senses.h"

#include <systemc>

namespace sim {

class Player : public sc_core::sc_module {
public:
    // Runs through `steps` from time 0, then notifies done().  Screenshots go into `out`.
    Player(const sc_core::sc_module_name& name, Board& board, Senses& senses,
           const std::vector<Step>& steps, std::filesystem::path out);

    const sc_core::sc_event& done() const { return done_; }
    bool finished() const { return finished_; }

    // One for each expectation and each wait with a timeout, in order.  Those that the run's end
    // cut off are there too, not met.
    std::vector<Expectation> results() const;

    // Why a screenshot or difference picture could not be written; empty if all could.
    const std::vector<std::string>& faults() const { return faults_; }

private:
    void run();
    void act(const Delay& step);
    void act(const Press& step);
    void act(const Hold& step);
    void act(const Release& step);
    void act(const TypeSerial& step);
    void act(const SetVoltage& step);
    void act(const TypeKeys& step);
    void act(const WaitFrame& step);
    void act(const WaitSerial& step);
    void act(const ExpectFrame& step);
    void act(const ExpectTone& step);
    void act(const ExpectSilence& step);
    void act(const ExpectLeds& step);
    void act(const ExpectHex& step);
    void act(const TakeScreenshot& step);

    void decide(bool met, std::string detail);
    // Waits for `event` until `met()` or the timeout; false on timeout.
    template <class Condition>
    bool wait_until(const sc_core::sc_event& event, SimTime timeout, Condition met);
    template <class Condition>
    bool poll_until(SimTime timeout, Condition met);

    Board& board_;
    Senses& senses_;
    const std::vector<Step>& steps_;
    const std::filesystem::path out_;
    std::size_t current_ = 0;
    std::vector<Expectation> results_;
    std::vector<std::string> faults_;
    bool finished_ = false;
    sc_core::sc_event done_;
};

}  // namespace sim
