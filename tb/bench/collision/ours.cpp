// ours.cpp - the project's broad phases as contenders.
#include "collision/broad_phase.h"
#include "contender.h"

namespace bench {
namespace {

unsigned size(const Boxes& boxes) { return static_cast<unsigned>(boxes.size()); }

template <class Algorithm>
class Kept : public Contender {
public:
    void tick(const Boxes& boxes, collision::PairList& pairs) override {
        algorithm_.find(boxes.data(), size(boxes), pairs);
    }

private:
    Algorithm algorithm_;
};

template <class Algorithm>
class Anew : public Contender {
public:
    void tick(const Boxes& boxes, collision::PairList& pairs) override {
        Algorithm{}.find(boxes.data(), size(boxes), pairs);
    }
};

}  // namespace

std::unique_ptr<Contender> strips() { return std::make_unique<Kept<collision::Strips>>(); }
std::unique_ptr<Contender> strips_anew() { return std::make_unique<Anew<collision::Strips>>(); }
std::unique_ptr<Contender> sweep() { return std::make_unique<Kept<collision::Sweep>>(); }
std::unique_ptr<Contender> sweep_anew() { return std::make_unique<Anew<collision::Sweep>>(); }
std::unique_ptr<Contender> simd() { return std::make_unique<Kept<collision::Simd>>(); }

}  // namespace bench
