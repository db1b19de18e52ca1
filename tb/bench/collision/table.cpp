// table.cpp - see table.h
#include "table.h"

#include <fmt/core.h>

namespace bench {
namespace {

constexpr char ROW[] = "{:<45} {:>7} {:<27} {:>8} {:>10} {:>12}  {}\n";

const char* verdict(bool met) { return met ? "met" : "MISSED"; }

}  // namespace

void print_header() {
    fmt::print(ROW, "", "ns/box", "against", "ns/box", "measured", "wanted", "");
}

void print_ratio(const std::string& what, double ours, const std::string& their_name,
                 std::optional<double> theirs, std::optional<double> wanted) {
    const std::string goal = wanted ? fmt::format(">= {:g} x", *wanted) : "";
    if (theirs)
        fmt::print(ROW, what, fmt::format("{:.1f}", ours), their_name,
                   fmt::format("{:.1f}", *theirs), fmt::format("{:.2f} x", *theirs / ours), goal,
                   wanted ? verdict(*theirs / ours >= *wanted) : "");
    else
        fmt::print(ROW, what, fmt::format("{:.1f}", ours), their_name, "", "", goal,
                   "not installed");
}

void print_limit(const std::string& what, double measured, const char* unit, double wanted) {
    fmt::print(ROW, what, "", "", "", fmt::format("{:.2f} {}", measured, unit),
               fmt::format("<= {:g} {}", wanted, unit), verdict(measured <= wanted));
}

}  // namespace bench
