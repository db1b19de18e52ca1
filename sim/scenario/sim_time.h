// sim_time.h - simulated time in picoseconds, as scenario files write it: 500ms, 1.5s, 20us, 16ns
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace sim {

struct SimTime {
    std::uint64_t ps = 0;

    // Digits, perhaps a point and more digits, then s, ms, us or ns.  No value for any other text,
    // for more than an hour, and for fractions of a picosecond.
    static std::optional<SimTime> parse(std::string_view text);

    bool operator==(SimTime other) const { return ps == other.ps; }
    bool operator<(SimTime other) const { return ps < other.ps; }
};

constexpr SimTime MAX_SIM_TIME{3'600'000'000'000'000};  // an hour

// In the largest unit that gives at least 1, exactly: "1.5s", "80ms", "0s".
std::string to_string(SimTime time);
// " within 2s"; "" for no time at all.
std::string within(SimTime timeout);

}  // namespace sim
