// step.h - what a step of a scenario is
//
// A step is a class in a file of steps/, with an entry in that file's list (step_form.h).  It
// either does something to the board, an Action, or checks something, a Claim.  Only a claim can be
// met or not met.  A claim that the end of a run cuts off is reported as not met.
#pragma once

#include <optional>
#include <string>

#include "sim/scenario/sim_time.h"

namespace sim {

class BoardControl;
class StaticChecks;

enum class Goldens { ARE_THERE, MAY_BE_NEW };  // which the run writes then

struct Verdict {
    bool met;
    std::string detail;  // what was found instead; may be empty when met
};

class Step {
public:
    virtual ~Step() = default;
    Step(const Step&) = delete;
    Step& operator=(const Step&) = delete;

    // One line as a person would say it: "press keypad 5 for 80ms".
    virtual std::string describe() const = 0;

    // The least time that it takes, whatever the board does.
    virtual SimTime least() const { return {}; }

    // It acts on a Linux program: a run without one refuses it.
    virtual bool needs_linux() const { return false; }

    // Throws Refusal if the steps before it show that it is wrong.
    virtual void check(StaticChecks&) const {}

    // Reads the files that it needs; std::runtime_error, "expected ..., got ...", if it can not.
    virtual void load(Goldens) {}

    virtual bool decides() const = 0;
    virtual std::optional<Verdict> play(BoardControl& board) const = 0;  // a value if it decides()

private:
    friend class Action;
    friend class Claim;
    Step() = default;
};

class Action : public Step {
public:
    bool decides() const final { return false; }
    std::optional<Verdict> play(BoardControl& board) const final {
        act(board);
        return std::nullopt;
    }

private:
    virtual void act(BoardControl& board) const = 0;
};

class Claim : public Step {
public:
    bool decides() const final { return true; }
    std::optional<Verdict> play(BoardControl& board) const final { return decide(board); }

private:
    virtual Verdict decide(BoardControl& board) const = 0;
};

}  // namespace sim
