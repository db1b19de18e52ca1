// intervals.h - boxes of any number of axes that overlap, by sorted intervals on each.
//
//      ( a   ( b   ) a   ( c   ) b   ) c        on one axis: a-b and b-c, not a-c (Fig. 4)
//
// The paper's section "Improvement to the initial algorithm", Fig. 5, and the last paragraph of its
// conclusions: "the improved algorithm could be easily extended to work in n dimensions".  Sort the
// ends of all boxes along an axis.  Walk along it with a list of the open boxes, and pair each box
// that opens with all that are open.  The pairs that all axes have in common are the overlapping
// boxes.
//
// n boxes, d axes, k overlaps on an axis: d O(n log n) to sort, d O(k log k) to keep the sets, up
// to O(n) to find a box among the open ones when it closes.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <forward_list>
#include <iterator>
#include <set>
#include <vector>

#include "collision/collision_pair.h"
#include "collision/tally.h"

namespace collision {

// Pairs as the paper keeps them, in lexicographic order.
using PairSet = std::set<CollisionPair>;

// One end of a box on one axis.
struct Interval {
    const std::int32_t* position;
    bool opening;
    std::uint32_t index;  // of the box

    // At equal positions openings come first, because closed boxes that only touch overlap.
    bool operator<(const Interval& other) const {
        return *position != *other.position ? *position < *other.position
                                            : opening && !other.opening;
    }
};

// The open boxes, as the paper has them: a linked list with the newest in front.  A box that closes
// is likely to be near the front.
class OpenList {
public:
    explicit OpenList(std::size_t) {}

    auto begin() const { return open_.begin(); }
    auto end() const { return open_.end(); }
    void insert(std::uint32_t index) { open_.push_front(index); }
    void erase(std::uint32_t index) {
        auto before = open_.before_begin();
        while (*std::next(before) != index) ++before;
        open_.erase_after(before);
    }

private:
    std::forward_list<std::uint32_t> open_;
};

// The paper's first idea for future work, "a vector of some estimated size": the newest is at the
// end.  When a box closes, the last one moves to its place.
class OpenVector {
public:
    explicit OpenVector(std::size_t estimate) { open_.reserve(estimate); }

    auto begin() const { return open_.begin(); }
    auto end() const { return open_.end(); }
    void insert(std::uint32_t index) { open_.push_back(index); }
    void erase(std::uint32_t index) {
        *std::find(open_.rbegin(), open_.rend(), index) = open_.back();
        open_.pop_back();
    }

private:
    std::vector<std::uint32_t> open_;
};

// The paper's getPossibleCollided(): all pairs whose intervals overlap on one axis.
template <class Open, class Counter>
PairSet possible_pairs(std::vector<Interval>& intervals, Counter& counter) {
    PairSet pairs;
    Open open{intervals.size() / 2};
    std::sort(intervals.begin(), intervals.end());
    for (const Interval& interval : intervals) {
        if (interval.opening) {
            for (const std::uint32_t other : open) {
                counter.interval_pair();
                pairs.insert(pair_of(interval.index, other));
            }
            open.insert(interval.index);
        } else {
            open.erase(interval.index);
        }
    }
    return pairs;
}

template <unsigned AXES>
struct Box {
    std::array<std::int32_t, AXES> min, max;  // closed; min <= max on each axis
};

// Pairs of `count` boxes that overlap on all axes, in lexicographic order.  `ends(i, axis)` is
// box i's {pointer to min, pointer to max} there.
template <unsigned AXES, class Open, class Ends, class Counter>
PairList overlapping(std::uint32_t count, Ends ends, Counter& counter) {
    static_assert(AXES > 0, "a box has an axis at least");
    const auto on_axis = [&](unsigned axis) {
        std::vector<Interval> intervals;
        intervals.reserve(2 * std::size_t{count});
        for (std::uint32_t i = 0; i < count; ++i) {
            const auto [min, max] = ends(i, axis);
            intervals.push_back({min, true, i});
            intervals.push_back({max, false, i});
        }
        return possible_pairs<Open>(intervals, counter);
    };
    const auto intersection = [](const auto& a, const auto& b) {
        PairList both;
        std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(both));
        return both;
    };
    const PairSet first = on_axis(0);
    if constexpr (AXES == 1) {
        return {first.begin(), first.end()};
    } else {
        PairList pairs = intersection(first, on_axis(1));
        for (unsigned axis = 2; axis < AXES; ++axis) pairs = intersection(pairs, on_axis(axis));
        return pairs;
    }
}

// The same for an array of boxes.
template <unsigned AXES, class Open = OpenList>
PairList overlapping(const std::vector<Box<AXES>>& boxes) {
    struct Ends {
        const std::int32_t *min, *max;
    };
    NoTally uncounted;
    const auto ends = [&boxes](std::uint32_t i, unsigned axis) {
        return Ends{&boxes[i].min[axis], &boxes[i].max[axis]};
    };
    return overlapping<AXES, Open>(static_cast<std::uint32_t>(boxes.size()), ends, uncounted);
}

}  // namespace collision
