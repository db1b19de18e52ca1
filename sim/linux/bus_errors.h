// bus_errors.h - the end of the simulator when a file that a program has mapped cannot be accessed
//
// The host sends SIGBUS when another of its programs has made the file shorter, or when the disk
// has no room for a page of it.  What the program does then can no longer be right: a line at
// standard error, and exit code 2.  SIGBUS at other addresses goes to the handler that was there.
#pragma once

#include <cstdint>

namespace sim::bus_errors {

// Of the host's addresses from `begin` to `end`, until forget(begin).
void report(const std::uint8_t* begin, const std::uint8_t* end);
void forget(const std::uint8_t* begin);

}  // namespace sim::bus_errors
