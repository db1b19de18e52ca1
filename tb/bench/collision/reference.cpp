// reference.cpp - see reference.h
#include "reference.h"

#include <algorithm>
#include <numeric>

namespace bench {

collision::PairList reference(const Boxes& boxes) {
    std::vector<std::uint32_t> order(boxes.size());
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(), [&boxes](std::uint32_t a, std::uint32_t b) {
        return boxes[a].min.x < boxes[b].min.x;
    });
    std::vector<collision::Aabb> sorted;
    for (const std::uint32_t i : order) sorted.push_back(boxes[i]);

    collision::PairList pairs;
    for (std::size_t i = 0; i < sorted.size(); ++i)
        for (std::size_t j = i + 1; j < sorted.size() && sorted[j].min.x <= sorted[i].max.x; ++j)
            if (sorted[i].min.y <= sorted[j].max.y && sorted[j].min.y <= sorted[i].max.y)
                pairs.push_back(collision::pair_of(order[i], order[j]));
    std::sort(pairs.begin(), pairs.end());
    return pairs;
}

bool agrees(collision::PairList& found, const collision::PairList& reference) {
    std::sort(found.begin(), found.end());
    return found == reference;
}

}  // namespace bench
