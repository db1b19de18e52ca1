#include "sim/linux/bus_errors.h"

#include <signal.h>
#include <unistd.h>

#include <iterator>
#include <map>

namespace sim::bus_errors {

namespace {

// The signal comes from an access of the simulator's own, never while this changes.
std::map<const std::uint8_t*, const std::uint8_t*> ranges;  // ends by begins
struct sigaction before;

void on_bus_error(int number, siginfo_t* info, void*) {
    constexpr char MESSAGE[] =
        "de1sim: error: a file that the program has mapped was made shorter by another program, "
        "or the disk is full: expected --linux-root for this run alone, and room\n";
    constexpr int WRONG_INPUT = 2;
    const auto* const at = static_cast<const std::uint8_t*>(info->si_addr);
    const auto next = ranges.upper_bound(at);
    if (next != ranges.begin() && at < std::prev(next)->second) {
        [[maybe_unused]] const auto written = ::write(STDERR_FILENO, MESSAGE, sizeof MESSAGE - 1);
        _exit(WRONG_INPUT);
    }
    if (before.sa_handler != SIG_DFL && before.sa_handler != SIG_IGN) before.sa_handler(number);
    sigaction(SIGBUS, &before, nullptr);
}

}  // namespace

void report(const std::uint8_t* begin, const std::uint8_t* end) {
    static const int installed = [] {
        struct sigaction action {};
        action.sa_sigaction = on_bus_error;
        action.sa_flags = SA_SIGINFO;
        return sigaction(SIGBUS, &action, &before);
    }();
    static_cast<void>(installed);
    ranges[begin] = end;
}

void forget(const std::uint8_t* begin) { ranges.erase(begin); }

}  // namespace sim::bus_errors
