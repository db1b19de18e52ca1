#include "sim/process/interrupt.h"

#include <atomic>
#include <csignal>

namespace sim {

namespace {

// A signal handler can reach nothing else, and other threads ask too.
std::atomic<bool> came{false};
static_assert(std::atomic<bool>::is_always_lock_free);

void note(int) { came = true; }

}  // namespace

void note_interrupts() {
    std::signal(SIGINT, note);
    std::signal(SIGTERM, note);
    if (std::signal(SIGHUP, note) == SIG_IGN) std::signal(SIGHUP, SIG_IGN);  // nohup
}

bool interrupted() { return came; }

}  // namespace sim
