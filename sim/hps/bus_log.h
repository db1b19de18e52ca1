// bus_log.h - the processor's last accesses of the bus, as a person reads them.
//
// RAM, and memory that the program reaches directly, does not come past the bus and is not in it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <string>

#include "sim/hps/bus.h"

namespace sim {

class BusLog {
public:
    static constexpr std::size_t MOST = 50'000;

    // Where in the program an access comes from: an address, and its words; 0 and "" without one.
    struct Program {
        std::function<std::uint32_t()> at = [] { return 0; };
        std::function<std::string(std::uint32_t)> function = [](std::uint32_t) { return ""; };
    };

    // Watches the bus from now on, which must outlive it; keeps accesses that begin in this time.
    BusLog(Bus& bus, const sc_core::sc_time& from, const sc_core::sc_time& to, Program program);

    // A line per access, the oldest first: when, how long, read or write, address, value, register
    // or place, function.
    std::string text() const;

private:
    struct Entry {
        sc_core::sc_time begin, end;
        std::uint32_t address, value, pc;  // value: the first four bytes
        unsigned bytes;
        bool write, answered;
    };
    void add(const Bus::Access& access);

    const Bus& bus_;
    const sc_core::sc_time from_, to_;
    const Program program_;
    std::deque<Entry> entries_;
    std::uint64_t left_out_ = 0;
};

}  // namespace sim
