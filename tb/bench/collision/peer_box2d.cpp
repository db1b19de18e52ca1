// peer_box2d.cpp - Box2D's b2BroadPhase: a dynamic tree of fattened boxes, queried for what moved.
#include "contender.h"

#if BENCH_HAS_BOX2D
#include <box2d/b2_broad_phase.h>
#endif

namespace bench {
#if BENCH_HAS_BOX2D
namespace {

class Box2d : public Contender {
public:
    void tick(const Boxes& boxes, collision::PairList& pairs) override {
        for (std::size_t i = 0; i < boxes.size(); ++i) {
            // Integers below 2^24, which a float holds exactly.
            const auto& [min, max] = boxes[i];
            const b2AABB box = {{static_cast<float>(min.x), static_cast<float>(min.y)},
                                {static_cast<float>(max.x), static_cast<float>(max.y)}};
            auto* user_data = reinterpret_cast<void*>(i);
            if (i >= proxies_.size()) {
                proxies_.push_back(broad_phase_.CreateProxy(box, user_data));
            } else if (!broad_phase_.GetFatAABB(proxies_[i]).Contains(box)) {
                broad_phase_.MoveProxy(proxies_[i], box, b2Vec2_zero);
            } else {
                // Rare here.  MoveProxy would omit its pairs, TouchProxy would report them twice.
                broad_phase_.DestroyProxy(proxies_[i]);
                proxies_[i] = broad_phase_.CreateProxy(box, user_data);
            }
        }
        boxes_ = &boxes;
        pairs_ = &pairs;
        pairs.clear();
        broad_phase_.UpdatePairs(this);
    }

    // Called back by UpdatePairs, for boxes that overlap once fattened.
    void AddPair(void* a, void* b) {
        const auto i = static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(a));
        const auto j = static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(b));
        const collision::Aabb &p = (*boxes_)[i], &q = (*boxes_)[j];
        if (p.min.x <= q.max.x && q.min.x <= p.max.x && p.min.y <= q.max.y && q.min.y <= p.max.y)
            pairs_->push_back(collision::pair_of(i, j));
    }

private:
    b2BroadPhase broad_phase_;
    std::vector<int32> proxies_;
    const Boxes* boxes_ = nullptr;
    collision::PairList* pairs_ = nullptr;
};

}  // namespace

std::vector<Entry> box2d() {
    return {{"Box2D", []() -> std::unique_ptr<Contender> { return std::make_unique<Box2d>(); }}};
}
#else
std::vector<Entry> box2d() { return {}; }
#endif
}  // namespace bench
