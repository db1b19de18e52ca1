// sweep.cpp - see broad_phase.h
#include <utility>

#include "collision/broad_phase.h"
#include "pair_writer.h"
#include "radix_sort.h"

namespace collision {
namespace {

// Sums of up to 2^26 centres, in units of 2^12 so that their squares fit.
struct Spread {
    std::int64_t sum = 0, squares = 0;

    void add(std::int32_t min, std::int32_t max) {
        const std::int64_t centre = (std::int64_t{min} + max) >> 13;
        sum += centre;
        squares += centre * centre;
    }
    std::int64_t variance(unsigned count) const {
        const std::int64_t mean = sum / count;
        return squares / count - mean * mean;
    }
};

// The cost of sorting; the unit is one exchange of neighbours in the insertion sort.
constexpr unsigned OUT_OF_PLACE = 16;  // per misplaced box: mispredicted branches
constexpr unsigned ANEW = 6;           // per box by radix, less that of one in place
constexpr unsigned ALLOWANCE = 64;     // the first few boxes say little

constexpr unsigned SAMPLE = 256;  // boxes by which the present axis is judged

}  // namespace

// The axis along which the centres vary most.  The axis changes only if the other one is twice as
// good, because a change means sorting anew.  A sample is enough to keep the axis.
void Sweep::choose_axis(const Aabb* boxes, unsigned count) {
    const unsigned step = keys_.size() == count ? count / SAMPLE + 1 : 1;
    Spread x, y;
    for (unsigned i = 0; i < count; i += step) {
        x.add(boxes[i].min.x, boxes[i].max.x);
        y.add(boxes[i].min.y, boxes[i].max.y);
    }
    const unsigned seen = (count + step - 1) / step;
    const std::int64_t along_x = x.variance(seen), along_y = y.variance(seen);
    const bool change = along_y_ ? along_x > 2 * along_y : along_y > 2 * along_x;
    if (!change) return;
    along_y_ = !along_y_;
    keys_.clear();
}

std::uint64_t Sweep::key(const Aabb& box, std::uint32_t index) const {
    return detail::sort_key(along_y_ ? box.min.y : box.min.x, index);
}

// Computes and sorts the keys of all boxes.
void Sweep::sort(const Aabb* boxes, unsigned count) {
    keys_.resize(count);
    for (unsigned i = 0; i < count; ++i) keys_[i] = key(boxes[i], i);
    detail::radix_sort(keys_, spare_);
}

// Sorts the new boxes by insertion, beginning with the old order.  False as soon as that has cost
// more than sorting anew would.
bool Sweep::repair(const Aabb* boxes) {
    std::size_t work = 0, most = ALLOWANCE;
    for (std::size_t i = 0; i < keys_.size(); ++i) {
        const std::uint32_t index = detail::index_of(keys_[i]);
        const std::uint64_t moved = key(boxes[index], index);
        std::size_t place = i;
        for (; place > 0 && keys_[place - 1] > moved; --place) keys_[place] = keys_[place - 1];
        keys_[place] = moved;
        work += i - place + (place < i ? OUT_OF_PLACE : 0);
        most += ANEW;
        if (work > most) return false;
    }
    return true;
}

void Sweep::find(const Aabb* boxes, unsigned count, PairList& overlaps) {
    if (count == 0) return overlaps.clear();
    choose_axis(boxes, count);
    if (keys_.size() != count || !repair(boxes)) sort(boxes, count);
    entries_.clear();
    for (const std::uint64_t key : keys_) entries_.push_back(detail::index_of(key));
    const Aabb &first = boxes[entries_.front()], &last = boxes[entries_.back()];
    entries_.resize(count + detail::SLACK);
    const auto buckets = along_y_ ? detail::Buckets::of_one_unit(first.min.y, last.min.y)
                                  : detail::Buckets::of_one_unit(first.min.x, last.min.x);
    detail::SortedBoxes sorted = sorted_.fill(*kernels_, boxes, entries_.data(), count, buckets);
    if (along_y_) {
        std::swap(sorted.min_x, sorted.min_y);
        std::swap(sorted.max_x, sorted.max_y);
    }
    detail::PairWriter pairs(overlaps);
    kernels_->sweep(sorted, pairs);
    pairs.finish();
}

}  // namespace collision
