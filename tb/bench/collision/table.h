// table.h - the rows that `make bench-collision` prints: measured and required values.
#pragma once

#include <optional>
#include <string>

namespace bench {

void print_header();

// One row: our ns per box, theirs, the factor by which ours is faster, and whether it is at least
// `wanted`.  Without `theirs`: not installed.
void print_ratio(const std::string& what, double ours, const std::string& their_name,
                 std::optional<double> theirs, std::optional<double> wanted);

// One row: a number that must be at most, or below, `wanted`.
void print_limit(const std::string& what, double measured, const char* unit, double wanted);

}  // namespace bench
