// peer_bullet.cpp - Bullet's btDbvtBroadphase: two dynamic trees and a hashed cache of pairs.
#include "contender.h"

#if BENCH_HAS_BULLET
#include <BulletCollision/BroadphaseCollision/btDbvtBroadphase.h>
#endif

namespace bench {
#if BENCH_HAS_BULLET
namespace {

// Coordinates are integers below 2^24, which a float holds exactly.
void corners(const collision::Aabb& box, btVector3& min, btVector3& max) {
    min = {static_cast<btScalar>(box.min.x), static_cast<btScalar>(box.min.y), 0};
    max = {static_cast<btScalar>(box.max.x), static_cast<btScalar>(box.max.y), 0};
}

template <bool DEFERRED>
class Bullet : public Contender {
public:
    Bullet() { broadphase_.m_deferedcollide = DEFERRED; }

    ~Bullet() override {
        for (btBroadphaseProxy* proxy : proxies_) broadphase_.destroyProxy(proxy, nullptr);
    }

    void tick(const Boxes& boxes, collision::PairList& pairs) override {
        btVector3 min, max;
        for (std::size_t i = 0; i < boxes.size(); ++i) {
            corners(boxes[i], min, max);
            if (i < proxies_.size()) {
                broadphase_.setAabb(proxies_[i], min, max, nullptr);
            } else {
                auto* index = reinterpret_cast<void*>(i);
                proxies_.push_back(broadphase_.createProxy(min, max, 0, index, 1, 1, nullptr));
            }
        }
        broadphase_.calculateOverlappingPairs(nullptr);
        pairs.clear();
        const btBroadphasePairArray& found =
            broadphase_.getOverlappingPairCache()->getOverlappingPairArray();
        for (int i = 0; i < found.size(); ++i) {  // the cache keeps separated pairs for a while
            const btBroadphaseProxy &a = *found[i].m_pProxy0, &b = *found[i].m_pProxy1;
            if (a.m_aabbMin.x() <= b.m_aabbMax.x() && b.m_aabbMin.x() <= a.m_aabbMax.x() &&
                a.m_aabbMin.y() <= b.m_aabbMax.y() && b.m_aabbMin.y() <= a.m_aabbMax.y())
                pairs.push_back(collision::pair_of(index(a), index(b)));
        }
    }

private:
    static std::uint32_t index(const btBroadphaseProxy& proxy) {
        return static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(proxy.m_clientObject));
    }

    btDbvtBroadphase broadphase_;
    std::vector<btBroadphaseProxy*> proxies_;
};

}  // namespace

std::vector<Entry> bullet() {
    return {{"Bullet, pairs at once",
             []() -> std::unique_ptr<Contender> { return std::make_unique<Bullet<false>>(); }},
            {"Bullet, pairs deferred",
             []() -> std::unique_ptr<Contender> { return std::make_unique<Bullet<true>>(); }}};
}
#else
std::vector<Entry> bullet() { return {}; }
#endif
}  // namespace bench
