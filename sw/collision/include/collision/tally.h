// tally.h - how often an algorithm does what; or nothing of it, at no cost.
//
// Algorithms are templates over one of these two.
#pragma once

#include <cstdint>

namespace collision {

// Counts, a call.
struct Tally {
    std::uint64_t box_tests = 0;       // two boxes compared, equations (1) to (4)
    std::uint64_t interval_pairs = 0;  // pairs put into the set of an axis, again or anew
    std::uint64_t polygon_tests = 0;   // two polygons whose lines were looked at
    std::uint64_t line_tests = 0;      // a line against a line
    std::uint64_t copies = 0;          // polygons copied

    void box_test() { ++box_tests; }
    void interval_pair() { ++interval_pairs; }
    void polygon_test() { ++polygon_tests; }
    void line_test() { ++line_tests; }
    void copy() { ++copies; }
};

struct NoTally {
    void box_test() {}
    void interval_pair() {}
    void polygon_test() {}
    void line_test() {}
    void copy() {}
};

}  // namespace collision
