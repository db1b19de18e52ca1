// sweep.cpp - see broad_phase.h
#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "collision/broad_phase.h"
#include "lanes.h"
#include "pair_writer.h"

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

// A position in the upper half, biased so that it orders as unsigned; an index in the lower.
std::uint64_t sort_key(std::int32_t position, std::uint32_t index) {
    return std::uint64_t{static_cast<std::uint32_t>(position) ^ 0x80000000u} << 32 | index;
}
std::uint32_t index_of(std::uint64_t key) { return static_cast<std::uint32_t>(key); }

constexpr unsigned DIGIT_BITS = 11, DIGITS = 3, FIRST_BIT = 32;

unsigned digit(std::uint64_t key, unsigned pass) {
    return key >> (FIRST_BIT + DIGIT_BITS * pass) & ((1u << DIGIT_BITS) - 1);
}

// Sorts by the upper 32 bits; equal ones keep their order.  `spare` is resized to match.  O(count).
//
// Source: Knuth, The Art of Computer Programming 3, 5.2.5, least significant digit first.
void radix_sort(std::vector<std::uint64_t>& keys, std::vector<std::uint64_t>& spare) {
    std::array<std::array<std::uint32_t, 1u << DIGIT_BITS>, DIGITS> places{};
    for (const std::uint64_t key : keys)
        for (unsigned pass = 0; pass < DIGITS; ++pass) ++places[pass][digit(key, pass)];
    spare.resize(keys.size());
    for (unsigned pass = 0; pass < DIGITS; ++pass) {
        if (keys.empty() || places[pass][digit(keys[0], pass)] == keys.size()) continue;
        std::uint32_t place = 0;
        for (std::uint32_t& of_digit : places[pass]) {
            const std::uint32_t count = of_digit;
            of_digit = place;
            place += count;
        }
        for (const std::uint64_t key : keys) spare[places[pass][digit(key, pass)]++] = key;
        keys.swap(spare);
    }
}

// One array for each edge, so that a vector has the same edge of several boxes.  The boxes are
// sorted by min_x.  After them are PADDING that overlap nothing, so that a vector may be read
// beyond the end.
constexpr unsigned PADDING = lanes::INTS;
struct SortedBoxes {
    std::int32_t *min_x, *max_x, *min_y, *max_y;
    const std::uint32_t* index;  // of each box in the caller's array
    unsigned count;
};

// Writes the pairs of each box with those after it.
void sweep(const SortedBoxes boxes, PairWriter& to) {
    using lanes::Ints;
    PairWriter pairs = to;
    for (unsigned row = 0; row < boxes.count; ++row) {
        pairs.need(boxes.count - row + lanes::INTS);
        const std::int32_t end = boxes.max_x[row];
        const Ints max_x = end - Ints{};
        const Ints min_y = boxes.min_y[row] - Ints{}, max_y = boxes.max_y[row] - Ints{};
        for (std::uint32_t j = row + 1; j < boxes.count && boxes.min_x[j] <= end;
             j += lanes::INTS) {
            const Ints apart = (lanes::load<Ints>(boxes.min_x + j) > max_x) |
                               (lanes::load<Ints>(boxes.min_y + j) > max_y) |
                               (lanes::load<Ints>(boxes.max_y + j) < min_y);
            lanes::append(pairs, boxes.index[row], boxes.index + j, ~apart);
        }
    }
    to = pairs;
}

}  // namespace

// The axis along which the centres vary most.  The axis changes only if the other one is twice as
// good, because a change means sorting again.  A sample is enough to keep the axis.
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
    return sort_key(along_y_ ? box.min.y : box.min.x, index);
}

// Computes and sorts the keys of all boxes.
void Sweep::sort(const Aabb* boxes, unsigned count) {
    keys_.resize(count);
    for (unsigned i = 0; i < count; ++i) keys_[i] = key(boxes[i], i);
    radix_sort(keys_, spare_);
}

// Sorts the new boxes by insertion, beginning with the old order.  False as soon as that has cost
// more than sorting again would.
bool Sweep::repair(const Aabb* boxes) {
    std::size_t work = 0, most = ALLOWANCE;
    for (std::size_t i = 0; i < keys_.size(); ++i) {
        const std::uint32_t index = index_of(keys_[i]);
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
    const std::size_t size = count + PADDING;
    if (index_.size() < size) {
        edges_.resize(4 * size);
        index_.resize(size);
    }
    SortedBoxes sorted = {edges_.data(),
                          edges_.data() + size,
                          edges_.data() + 2 * size,
                          edges_.data() + 3 * size,
                          index_.data(),
                          count};
    for (unsigned i = 0; i < count; ++i) {
        const Aabb& box = boxes[index_[i] = index_of(keys_[i])];
        sorted.min_x[i] = box.min.x;
        sorted.max_x[i] = box.max.x;
        sorted.min_y[i] = box.min.y;
        sorted.max_y[i] = box.max.y;
    }
    if (along_y_) {
        std::swap(sorted.min_x, sorted.min_y);
        std::swap(sorted.max_x, sorted.max_y);
    }
    std::fill_n(sorted.min_x + count, PADDING, std::numeric_limits<std::int32_t>::max());
    PairWriter pairs(overlaps);
    sweep(sorted, pairs);
    pairs.finish();
}

}  // namespace collision
