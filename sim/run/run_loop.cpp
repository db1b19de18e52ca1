// run_loop.cpp - see run_loop.h
#include "sim/run/run_loop.h"

#include <algorithm>

#include "sim/process/interrupt.h"
#include "sim/text/seconds.h"

namespace sim {

using sc_core::sc_time;

namespace {

RunEnd run_end(const Chip::End& end) {
    switch (end.kind) {
        case Chip::End::Kind::FINISHED: return RunEnd::PROGRAM_ENDED;
        case Chip::End::Kind::FAILED: return RunEnd::DESIGN_STOPPED;
        case Chip::End::Kind::BROKEN: break;
    }
    return RunEnd::DESIGN_OSCILLATES;
}

}  // namespace

Finish::Finish(const sc_core::sc_module_name& name, const sc_core::sc_event& done,
               const sc_core::sc_event& faulted)
    : sc_module{name} {
    SC_HAS_PROCESS(Finish);
    SC_METHOD(pause);
    sensitive << done << faulted;
    dont_initialize();
}

// How the run has ended by now, if it has.
std::optional<RunEnd> RunLoop::end() {
    const sc_time last_looks{100, sc_core::SC_MS};  // at what the program has left behind
    if (interrupted() || (debugger && debugger->killed())) return RunEnd::INTERRUPTED;
    if (recorder.failed()) return RunEnd::INTERRUPTED;
    if (computer && computer->processor().fault()) return RunEnd::FIRMWARE_FAULT;
    if (const auto ended = board.chip().end()) return run_end(*ended);
    if (alone && !client && computer->program_cpu()->ended_for() >= last_looks &&
        !computer->is_sending())
        return RunEnd::PROGRAM_ENDED;
    if (client ? client->has_left() : !duration && !alone && runner.finished())
        return RunEnd::ALL_STEPS_DONE;
    if (duration && sc_core::sc_time_stamp() >= sc_time::from_value(duration->ps))
        return runner.finished() && !alone ? RunEnd::ALL_STEPS_DONE : RunEnd::DURATION_REACHED;
    return std::nullopt;
}

RunEnd RunLoop::run() {
    const sc_time slice{1, sc_core::SC_MS};
    const sc_time most = duration ? sc_time::from_value(duration->ps) : sc_core::sc_max_time();
    double renew_s = 0;
    for (;;) {
        if (debugger) debugger->poll();
        if (const auto ended = end()) {
            if (client) client->leave();
            if (*ended == RunEnd::FIRMWARE_FAULT) empty_the_consoles();
            return *ended;
        }
        sc_core::sc_start(std::min(slice, most - sc_core::sc_time_stamp()));
        if (recorder.output) recorder.output->flush();
        const double now_s = seconds(sc_core::sc_time_stamp());
        progress.show(now_s, board.monitor.frames());
        if (now_s >= renew_s) {
            crash_report.renew(now_s, board.monitor.frames());
            renew_s = now_s + 0.05;
        }
    }
}

void RunLoop::empty_the_consoles() {
    // A full FIFO at 9600 baud.
    const sc_time most = sc_core::sc_time_stamp() + sc_time{150, sc_core::SC_MS};
    const sc_time step{20, sc_core::SC_US};  // in which a JTAG UART's FIFO is emptied
    for (bool more = true; more && sc_core::sc_time_stamp() < most && !recorder.failed();) {
        more = computer->is_printing();
        sc_core::sc_start(step);
        more |= computer->is_printing();
    }
}

}  // namespace sim
