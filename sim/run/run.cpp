#include "sim/run/run.h"

#include <new>

#include "sim/process/interrupt.h"
#include "sim/run/session.h"
#include "sim/text/messages.h"

namespace sim {

namespace {

// std::runtime_error in place of std::bad_alloc, which says nothing.
RunPlan planned(const RunDescription& description) {
    try {
        return plan_run(description);
    } catch (const std::bad_alloc&) {
        throw std::runtime_error{"out of memory while reading the scenario"};
    }
}

}  // namespace

ExitCode run(const RunDescription& description, const Firmware& firmware,
             const RunClientMaker& make_client) {
    try {
        RunPlan plan = planned(description);
        note_interrupts();
        Session session{std::move(plan), firmware, make_client};
        return session.run();
    } catch (const ScenarioError& e) {
        message(e.what());
    } catch (const std::bad_alloc&) {
        complain("out of memory while setting up the board");
    } catch (const std::exception& e) {  // IoError, an ELF that is none
        complain(e.what());
    }
    return WRONG_INPUT;
}

}  // namespace sim
