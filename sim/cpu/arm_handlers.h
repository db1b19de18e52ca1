// arm_handlers.h - whether a program returns from its aborts and undefined instructions
//
// A program that takes one must leave the mode of its handler, ABT or UND, for another than IRQ and
// FIQ.  Otherwise it has failed:
//   - at once when it has looped on one instruction (b .) in that mode for 100 ms, with IRQ masked;
//   - at once when its handler has returned to the same instruction with the same registers a
//     thousand times;
//   - when the run ends while it loops on one instruction, or is still in that mode more than 1 ms
//     after the exception: unfinished().
// So a handler may take its time, print, sleep and be interrupted, as long as it comes to an end.
//
// A program that loops on one instruction with IRQ and FIQ masked has ended: only a reset could end
// the loop.
//
// Not handled: a handler that changes its mode to SVC or SYS and stays there counts as left.  A
// handler that loops until a watchdog resets the board must be reset within those 100 ms.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include <systemc>

#include "sim/cpu/abort_log.h"
#include "sim/cpu/arm_core.h"
#include "sim/cpu/arm_exceptions.h"
#include "sim/cpu/arm_time.h"

namespace sim {

class ArmHandlers {
public:
    // `log`: a line of text for each abort.
    ArmHandlers(const ArmCore& core, const ArmTime& time,
                std::function<void(const std::string&)> log)
        : core_{core}, time_{time}, abort_log_{std::move(log)} {}

    // After a reset.
    void reset() { open_.reset(); }

    // In the handler of an abort or undefined instruction, or in an interrupt of that handler.
    bool in_handler() const;
    // At the end of a quantum: what was taken and left again may be logged.
    void log_handled() {
        if (open_ && !in_handler()) abort_log_.handled();
    }

    // Before an exception is entered, of any kind.
    void begin() {
        if (!in_handler()) leave();
    }
    // True if an abort or undefined instruction happens again at the same place of its own handler.
    bool happens_again(ArmException exception);
    // One of these is entered; `text`: what and where it was.
    void enter(ArmException exception, const std::string& text);
    // The program has failed by the one with this text, which is not logged again.
    void failed_by(const std::string& text) { abort_log_.failed(text); }
    // The program has failed otherwise.
    void failed() { abort_log_.handled(); }

    // The handler is executed in single steps, since its exception repeats.
    bool is_watched_closely() const { return open_ && repetitions_ >= MANY_REPETITIONS; }

    // The program has taken an exception whose handler it has not left yet.
    bool has_open() const { return open_.has_value(); }
    // After each quantum in such a handler: why the program has failed, if it has; `where` as
    // ArmCpu has it.
    std::optional<std::string> failure(const std::string& where);
    // ... by this exception.  `goes_on`: a debugger lets it.
    ArmException exception() const { return open_->exception; }
    void conclude_failure(bool goes_on);

    // The state in which the program cannot have meant to end, or nothing.
    std::optional<std::string> unfinished(const std::string& where) const;
    // At the run's end; `failed`: the program has.
    void end(bool failed);

    // Loops on one instruction with IRQ and FIQ masked.
    bool stands_still() const;

private:
    static constexpr unsigned MANY_REPETITIONS = 1000;
    static sc_core::sc_time spin_limit() { return {100, sc_core::SC_MS}; }
    static sc_core::sc_time handler_grace() { return {1, sc_core::SC_MS}; }

    bool spins() const;
    void leave();
    void count_repetition();
    std::string never_left(const std::string& where) const;

    struct Open {
        ArmException exception;
        std::string text;             // what and where it was
        sc_core::sc_time since;       // taken
        sc_core::sc_time spins_from;  // loops on one instruction; now, if it does not
    };

    const ArmCore& core_;
    const ArmTime& time_;
    AbortLog abort_log_;
    std::optional<Open> open_;  // the exception whose handler it is in
    // The registers with which an exception happened, and how often with the same.
    std::array<std::uint32_t, 17> repeated_state_{};
    unsigned repetitions_ = 0;
    std::uint32_t nested_pc_ = 1;  // of the last abort within an abort
};

}  // namespace sim
