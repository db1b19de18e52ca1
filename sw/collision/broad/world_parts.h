// world_parts.h - boxes copied into the parts of the world that they reach.
#pragma once

#include <cstdint>
#include <vector>

#include "collision/broad/kernels.h"

namespace collision {

class WorldParts {
public:
    // Into all parts that a box reaches, as a visitor into all but the lowest; into half as many
    // parts and so on where there would be more than MOST_COPIES visitors a box.  O(count + parts).
    void cut(const Kernels& kernels, const BoxList& list, const StripParts& parts);

    static constexpr unsigned MOST_COPIES = 2;

    // Valid until the next cut.  PACKED_SLACK entries of some kind lie behind each part.
    unsigned count() const { return static_cast<unsigned>(ends_.size()); }
    BoxList part(unsigned i) const {
        const unsigned count = ends_[i] - starts_[i];
        return is_packed_ ? list_of(packed_.data() + starts_[i], count)
                          : list_of(entries_.data() + starts_[i], count);
    }

    std::size_t bytes() const {  // of memory in use
        return packed_.capacity() * sizeof(PackedEntry) + entries_.capacity() * sizeof(Entry) +
               4 * (starts_.capacity() + ends_.capacity());
    }

private:
    enum class Outcome { DONE, NO_ROOM, TOO_LONG };

    template <class Pack>
    bool cut_as(const Kernels& kernels, const BoxList& list, StripParts parts,
                std::vector<typename Pack::Written>& entries);
    template <class Pack>
    Outcome scatter(const Kernels& kernels, const BoxList& list, const StripParts& parts,
                    unsigned spare, std::vector<typename Pack::Written>& entries);
    void guess(const BoxList& list, const StripParts& parts);
    bool measure(const Kernels& kernels, const BoxList& list, const StripParts& parts);

    std::vector<PackedEntry> packed_;  // part by part
    std::vector<Entry> entries_;       // in their place where a side is too long for those
    bool is_packed_ = true;
    bool all_short_ = true;  // as far as the last cut has seen: so the next one is tried
    std::vector<std::uint32_t> starts_;  // of the room for each part, and the end of the last
    std::vector<std::uint32_t> ends_;    // of what is there; before that, how much room it takes
};

}  // namespace collision
