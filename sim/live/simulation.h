// simulation.h - the process that simulates, `de1sim run`, and the wire to it.
#pragma once

#include <sys/types.h>

#include <memory>
#include <string>

#include "sim/live/wire.h"
#include "sim/run/description.h"

namespace sim::live {

class Simulation {
public:
    // Starts it; `first`, if there is one, is its first message.
    // std::runtime_error.
    explicit Simulation(RunDescription run, const std::string& first = "");
    ~Simulation() { end(); }
    Simulation(const Simulation&) = delete;
    Simulation& operator=(const Simulation&) = delete;

    Wire& wire() { return *wire_; }
    // Waits for a process that has gone; its exit code, 128 + n for signal n.
    int reap();
    // Asks it to end, for which it writes its files, and ends it if it does not within ten seconds.
    // Its exit code, as above; that of the first end if it has ended before.
    int end();

private:
    pid_t child_ = -1;
    int code_ = 0;
    std::unique_ptr<Wire> wire_;
};

}  // namespace sim::live
