// strip_grid.h - the boxes of a few strips, strip by strip, sorted by where they begin on the x
// axis.
#pragma once

#include <cstdint>
#include <vector>

#include "collision/broad/strip_of.h"
#include "collision/broad/strip_rows.h"
#include "collision/polygon.h"

namespace collision {

// A box with its index, so that what is tested together lies together.
struct Entry {
    Aabb box;  // min.y may be VISITOR
    std::uint32_t index;
};

struct FromBoxes {
    const Aabb* boxes;
    const Aabb& box(unsigned i) const { return boxes[i]; }
    std::uint32_t index(unsigned i) const { return i; }
};

struct FromEntries {
    const Entry* entries;
    const Aabb& box(unsigned i) const { return entries[i].box; }
    std::uint32_t index(unsigned i) const { return entries[i].index; }
};

// The axes exchanged if `along_y`.
struct FromAxis {
    const Aabb* boxes;
    bool along_y;
    Aabb box(unsigned i) const {
        const auto& [min, max] = boxes[i];
        return along_y ? Aabb{{min.y, min.x}, {max.y, max.x}} : boxes[i];
    }
    std::uint32_t index(unsigned i) const { return i; }
};

class StripGrid {
public:
    // Puts each box into all strips that it reaches, there into the bucket of min.x.  False, and no
    // strips, if most boxes share their bucket with many others or if they have too many copies:
    // the cost is then out of proportion.  From FromBoxes or FromEntries into StripOf, or from
    // FromEntries into OneStrip.  O(count + buckets).
    template <class Source, class Strip>
    bool sort(const Source& source, unsigned count, const Strip& strip_of,
              const BucketOf& bucket_of);

    // One strip, in the exact order of min.x whatever they share.  O(count).
    void sort_exactly(const Entry* entries, unsigned count);

    // One strip of what the sort keys stand for, which are in order.  From FromEntries or FromAxis;
    // count > 0.  O(count).
    template <class Source>
    void arrange(const Source& source, const std::vector<std::uint64_t>& keys);

    // Valid until the next call of any of these.
    unsigned strips() const { return static_cast<unsigned>(strips_.size()); }
    const StripRows& rows(unsigned strip) const { return strips_[strip]; }

    std::size_t bytes() const;  // of memory in use

private:
    void reserve(std::size_t places);
    void put(std::size_t place, const Aabb& box, std::int32_t min_y, std::uint32_t index);
    void end_strip(std::size_t start, std::size_t end, const BucketOf& bucket_of);

    std::int32_t* edge(unsigned which) { return edges_.data() + which * stride_; }

    std::size_t stride_ = 0;  // from one array to the next
    // Where boxes go one by one, a write each; then the same turned into an array an edge.
    std::vector<Aabb> sorted_;
    std::vector<std::int32_t> edges_;  // min_x, max_x, min_y, max_y
    std::vector<std::uint32_t> index_;
    std::vector<std::uint32_t> places_;  // of the next box of each bucket of each strip
    std::vector<StripRows> strips_;
    std::vector<std::uint64_t> keys_, spare_;
};

}  // namespace collision
