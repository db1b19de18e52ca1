// seconds.h - simulated time as reports and messages show it
#pragma once

#include <cstdint>

#include <systemc>

namespace sim {

// The nearest number: 0.1 for 100 ms.  SystemC's to_seconds() has 0.09999999999999999 for it.
inline double seconds(std::uint64_t ps) { return static_cast<double>(ps) / 1e12; }
inline double seconds(const sc_core::sc_time& time) { return seconds(time.value()); }

}  // namespace sim
