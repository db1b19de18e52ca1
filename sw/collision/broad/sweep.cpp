// sweep.cpp - see sweep.h
#include "collision/broad/sweep.h"

#include "collision/broad/pair_writer.h"
#include "collision/broad/radix_sort.h"

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

}  // namespace

// The axis along which the centres vary most.  The other one must be twice as good to be worth the
// sorting.
void Sweep::choose_axis(const Aabb* boxes, unsigned count) {
    Spread x, y;
    for (unsigned i = 0; i < count; ++i) {
        x.add(boxes[i].min.x, boxes[i].max.x);
        y.add(boxes[i].min.y, boxes[i].max.y);
    }
    const std::int64_t along_x = x.variance(count), along_y = y.variance(count);
    const bool change = along_y_ ? along_x > 2 * along_y : along_y > 2 * along_x;
    if (!change) return;
    along_y_ = !along_y_;
    entries_.clear();
}

Sweep::Entry Sweep::entry(const Aabb* boxes, std::uint32_t index) const {
    const Aabb& box = boxes[index];
    return along_y_ ? Entry{box.min.y, box.max.y, box.min.x, box.max.x, index}
                    : Entry{box.min.x, box.max.x, box.min.y, box.max.y, index};
}

void Sweep::sort(const Aabb* boxes, unsigned count) {
    keys_.resize(count);
    for (unsigned i = 0; i < count; ++i)
        keys_[i] = sort_key(along_y_ ? boxes[i].min.y : boxes[i].min.x, i);
    radix_sort(keys_, spare_);
    entries_.resize(count);
    for (unsigned i = 0; i < count; ++i) entries_[i] = entry(boxes, index_of(keys_[i]));
}

// Takes the new boxes over in the old order and sorts by insertion; false if that is too much work.
bool Sweep::repair(const Aabb* boxes) {
    std::size_t moves = 0;
    const std::size_t most = MOST_MOVES * entries_.size();
    for (std::size_t i = 0; i < entries_.size(); ++i) {
        const Entry moved = entry(boxes, entries_[i].index);
        std::size_t place = i;
        for (; place > 0 && entries_[place - 1].min > moved.min; --place)
            entries_[place] = entries_[place - 1];
        entries_[place] = moved;
        moves += i - place;
        if (moves > most) return false;
    }
    return true;
}

void Sweep::find(const Aabb* boxes, unsigned count, PairList& overlaps) {
    if (count == 0) return overlaps.clear();
    choose_axis(boxes, count);
    if (entries_.size() != count || !repair(boxes)) sort(boxes, count);

    std::size_t i = 0, j = 1;
    PairWriter writer(overlaps);
    writer.write(count, [&](PairRoom& room) {
        for (; i < count; ++i, j = i + 1) {
            const Entry& a = entries_[i];
            for (; j < count && entries_[j].min <= a.max; ++j) {
                if (room.left() == 0) return false;
                const Entry& b = entries_[j];
                room.append(a.index, b.index,
                            (a.side_min <= b.side_max) & (b.side_min <= a.side_max));
            }
        }
        return true;
    });
    writer.finish();
}

}  // namespace collision
