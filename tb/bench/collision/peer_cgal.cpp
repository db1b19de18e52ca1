// peer_cgal.cpp - CGAL's box_self_intersection_d: streamed segment trees, all pairs below a cutoff.
#include "contender.h"

#if BENCH_HAS_CGAL
#include <CGAL/Box_intersection_d/Box_with_info_d.h>
#include <CGAL/box_intersection_d.h>
#endif

namespace bench {
#if BENCH_HAS_CGAL
namespace {

using Box = CGAL::Box_intersection_d::Box_with_info_d<int, 2, std::uint32_t>;

// The boxes are sorted in place, so they are created anew in each tick, as in the manual's
// examples.
template <int CUTOFF>
class Cgal : public Contender {
public:
    void tick(const Boxes& boxes, collision::PairList& pairs) override {
        boxes_.clear();
        for (const collision::Aabb& box : boxes) {
            int min[] = {box.min.x, box.min.y}, max[] = {box.max.x, box.max.y};
            boxes_.emplace_back(min, max, static_cast<std::uint32_t>(boxes_.size()));
        }
        pairs.clear();
        CGAL::box_self_intersection_d(
            boxes_.begin(), boxes_.end(),
            [&pairs](const Box& a, const Box& b) {
                pairs.push_back(collision::pair_of(a.info(), b.info()));
            },
            std::ptrdiff_t{CUTOFF});
    }

private:
    std::vector<Box> boxes_;
};

template <int CUTOFF>
Entry entry() {
    return {"CGAL, cutoff " + std::to_string(CUTOFF),
            []() -> std::unique_ptr<Contender> { return std::make_unique<Cgal<CUTOFF>>(); }};
}

}  // namespace

std::vector<Entry> cgal() {
    // Up to cutoffs that are too large for all sizes.
    return {entry<10>(),  entry<30>(),   entry<70>(),   entry<150>(), entry<300>(),
            entry<700>(), entry<1500>(), entry<3000>(), entry<6000>()};
}
#else
std::vector<Entry> cgal() { return {}; }
#endif
}  // namespace bench
