// peer_rtree.cpp - Boost.Geometry's R-tree: bulk loaded, since all boxes move, and queried by each.
#include "contender.h"

#if BENCH_HAS_RTREE
#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/iterator/function_output_iterator.hpp>
#endif

namespace bench {
#if BENCH_HAS_RTREE
namespace {

namespace geometry = boost::geometry;
using Point = geometry::model::point<int, 2, geometry::cs::cartesian>;
using Box = geometry::model::box<Point>;
using Value = std::pair<Box, std::uint32_t>;

template <unsigned NODE>
class Rtree : public Contender {
public:
    void tick(const Boxes& boxes, collision::PairList& pairs) override {
        values_.clear();
        for (const auto& [min, max] : boxes)
            values_.push_back(
                {Box({min.x, min.y}, {max.x, max.y}), static_cast<std::uint32_t>(values_.size())});
        const geometry::index::rtree<Value, geometry::index::linear<NODE>> tree(values_);
        pairs.clear();
        for (std::uint32_t i = 0; i < boxes.size(); ++i) {
            const auto found = [i, &pairs](const Value& value) {
                if (i < value.second) pairs.push_back({i, value.second});
            };
            const auto& [min, max] = boxes[i];
            tree.query(geometry::index::intersects(Box({min.x, min.y}, {max.x, max.y})),
                       boost::make_function_output_iterator(found));
        }
    }

private:
    std::vector<Value> values_;
};

template <unsigned NODE>
Entry entry() {
    return {"R-tree, " + std::to_string(NODE) + " a node",
            []() -> std::unique_ptr<Contender> { return std::make_unique<Rtree<NODE>>(); }};
}

}  // namespace

std::vector<Entry> rtree() { return {entry<8>(), entry<16>()}; }
#else
std::vector<Entry> rtree() { return {}; }
#endif
}  // namespace bench
