#include "tb/fuzz/collision/world.h"
#include "tb/fuzz/fuzz.h"

namespace fuzz {

// With more shapes the paper's algorithms, which note each pair in a set, would take most of the
// time; make test tries them with many (replay_test.cpp).
constexpr std::size_t MOST_WITH_ALL = 12;

void try_collision(std::string_view input) {
    try_world(reinterpret_cast<const std::uint8_t*>(input.data()), input.size(), MOST_WITH_ALL);
}

}  // namespace fuzz
