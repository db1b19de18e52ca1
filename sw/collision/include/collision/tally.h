// tally.h - counters of what an algorithm does, and a version that counts nothing at no cost.
//
// Algorithms are templates over one of these two.
#pragma once

#include <cstdint>

namespace collision {

// Operations per call.
struct Tally {
    std::uint64_t box_tests = 0;       // two boxes compared, equations (1) to (4)
    std::uint64_t interval_pairs = 0;  // insertions into the set of an axis, repeated ones too
    std::uint64_t polygon_tests = 0;   // two polygons whose lines were tested
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
