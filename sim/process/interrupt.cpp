#include "sim/process/interrupt.h"

#include <csignal>

namespace sim {

namespace {

volatile std::sig_atomic_t came = 0;  // a signal handler can reach nothing else

void note(int) { came = 1; }

}  // namespace

void note_interrupts() {
    std::signal(SIGINT, note);
    std::signal(SIGTERM, note);
    if (std::signal(SIGHUP, note) == SIG_IGN) std::signal(SIGHUP, SIG_IGN);  // nohup
}

bool interrupted() { return came != 0; }

}  // namespace sim
