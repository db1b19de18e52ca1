// process.h - a process of a Linux program: its memory, files, actions for signals, threads.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sim/board/signal_receiver.h"
#include "sim/linux/address_space.h"
#include "sim/linux/files.h"
#include "sim/linux/posix_timers.h"
#include "sim/linux/signals.h"
#include "sim/linux/thread.h"
#include "sim/linux/timers.h"

namespace sim {

struct KernelModule;

struct LinuxProcess {
    static constexpr int INIT = 1;                         // which adopts orphans; there is none
    static constexpr int SHELL = 100;                      // the parent of the first; there is none
    static constexpr int FIRST = SignalReceiver::PROGRAM;  // the one that the run is about

    int number, parent;
    std::shared_ptr<AddressSpace> memory;  // with its parent, after vfork
    LinuxFiles files;
    LinuxSignals signals{};
    PendingSignals pending{};                             // that all threads block
    std::vector<std::unique_ptr<LinuxThread>> threads{};  // the first one first
    std::uint32_t break_begin = 0, break_end = 0, umask = 022;
    std::uint64_t used_ns = 0, used_by_children_ns = 0;  // of the processor
    int group = FIRST, session = SHELL;
    bool stopped = false;
    std::optional<std::uint32_t> status{};    // once it has ended, as waitpid() has it
    unsigned end_signal = 0;                  // that its parent gets then
    std::map<std::uint32_t, int> segments{};  // of System V, by their addresses
    std::map<int, PosixTimer> timers{};       // timer_create()'s, by their numbers
    int next_timer = 0;                       // a number does not come again
    std::array<LinuxTimer, 3> itimers{};      // setitimer()'s: of the real time, of its own twice
    std::string command{}, command_line{};    // the program's path; words, each with a 0
    std::string folder = "/";                 // that it works in
    KernelModule* module = nullptr;           // that it is (modules.h), no program

    void set_command_line(const std::vector<std::string>& words) {
        command_line.clear();
        for (const std::string& word : words) command_line += word + '\0';
    }
};

}  // namespace sim
