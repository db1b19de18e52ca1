// random_code.h - random RISC-V instructions whose effects two processors can be compared by
//
// Without FMIN and FMAX: QEMU 5, which is in Unicorn 2, has the older rule of signalling NaNs.
#pragma once

#include <array>
#include <cstdint>
#include <random>
#include <vector>

namespace tb::riscv {

// Where the code and its data lie, and the registers that instructions leave alone: addresses.
constexpr std::uint32_t CODE = 0x1000, DATA = 0x10000, PART = 0x1000;
constexpr unsigned DATA_REG = 8, ATOMIC_REG = 9, CODE_REG = 10, FCSR_REG = 31;

struct State {
    std::array<std::uint32_t, 32> x{}, f{};
    std::vector<std::uint8_t> data = std::vector<std::uint8_t>(PART);

    bool operator==(const State& o) const { return x == o.x && f == o.f && data == o.data; }
};

class RandomCode {
public:
    explicit RandomCode(std::uint64_t seed) : random_{seed} {}

    // Sets fcsr from FCSR_REG, does `count` instructions, and reads fcsr into that register.
    std::vector<std::uint32_t> code(unsigned count);
    // Of values at which results are special.
    State state();

private:
    std::uint32_t any() { return static_cast<std::uint32_t>(random_()); }
    unsigned below(unsigned limit) { return any() % limit; }
    unsigned target();
    std::uint32_t instruction(unsigned index, unsigned count);
    std::uint32_t integer();
    std::uint32_t memory();
    std::uint32_t jump(unsigned index, unsigned count);
    std::uint32_t floating();
    std::uint32_t special_integer();
    std::uint32_t special_float();

    std::mt19937_64 random_;
};

}  // namespace tb::riscv
