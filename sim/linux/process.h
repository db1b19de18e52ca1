// process.h - a process of a Linux program: its memory, files, actions for signals, threads.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sim/linux/address_space.h"
#include "sim/linux/files.h"
#include "sim/linux/signals.h"
#include "sim/linux/thread.h"

namespace sim {

struct LinuxProcess {
    int number, parent;
    std::shared_ptr<AddressSpace> memory;  // with its parent, after vfork
    LinuxFiles files;
    LinuxSignals signals{};
    PendingSignals pending{};                             // that all threads block
    std::vector<std::unique_ptr<LinuxThread>> threads{};  // the first one first
    std::uint32_t break_begin = 0, break_end = 0, umask = 022;
    std::uint64_t used_ns = 0;  // of the processor
    bool stopped = false;
};

}  // namespace sim
