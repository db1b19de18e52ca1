#include "tb/fuzz/collision/world.h"
#include "tb/fuzz/fuzz.h"

namespace fuzz {

void try_collision(std::string_view input) {
    try_world(reinterpret_cast<const std::uint8_t*>(input.data()), input.size());
}

}  // namespace fuzz
