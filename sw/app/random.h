// random.h - a small seeded random number generator: the same numbers on every machine.
#pragma once

#include <cstdint>

namespace app {

// A Weyl sequence (odd step, so it visits all 2^32 states), then a bit mixer.
class Random {
public:
    explicit Random(std::uint32_t seed) : state_{seed} {}

    std::uint32_t next() {
        state_ += 0x9e3779b9u;  // 2^32 / golden ratio
        std::uint32_t bits = state_;
        bits = (bits ^ bits >> 16) * 0x85ebca6bu;
        bits = (bits ^ bits >> 13) * 0xc2b2ae35u;
        return bits ^ bits >> 16;
    }

    // From low to high, both included; high - low fits 31 bits.
    std::int32_t between(std::int32_t low, std::int32_t high) {
        const std::uint64_t width = static_cast<std::uint32_t>(high - low) + std::uint64_t{1};
        return low + static_cast<std::int32_t>(next() * width >> 32);
    }

private:
    std::uint32_t state_;
};

}  // namespace app
