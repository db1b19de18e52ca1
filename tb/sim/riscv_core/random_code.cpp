#include "tb/sim/riscv_core/random_code.h"

#include <iterator>

namespace tb::riscv {

namespace {

constexpr std::uint32_t FCSR = 0x003u << 20 | 0x73;
constexpr std::uint32_t FIRST = FCSR | FCSR_REG << 15 | 1 << 12;  // csrw fcsr, x31
constexpr std::uint32_t LAST = FCSR | 2 << 12 | FCSR_REG << 7;    // csrr x31, fcsr

}  // namespace

// A destination that no address is in.
unsigned RandomCode::target() {
    unsigned number;
    do number = below(31);
    while (number >= DATA_REG && number <= CODE_REG);
    return number;
}

std::vector<std::uint32_t> RandomCode::code(unsigned count) {
    std::vector<std::uint32_t> words{FIRST};
    for (unsigned i = 0; i < count; ++i) words.push_back(instruction(i, count));
    words.push_back(LAST);
    return words;
}

State RandomCode::state() {
    State state;
    for (std::uint32_t& x : state.x) x = special_integer();
    for (std::uint32_t& f : state.f) f = special_float();
    for (std::uint8_t& byte : state.data) byte = static_cast<std::uint8_t>(any());
    state.x[0] = 0;
    state.x[DATA_REG] = DATA + PART / 2;
    state.x[ATOMIC_REG] = DATA + below(PART / 4) * 4;
    state.x[CODE_REG] = CODE;
    state.x[FCSR_REG] = below(5) << 5 | below(32);
    return state;
}

std::uint32_t RandomCode::special_integer() {
    constexpr std::uint32_t SPECIAL[] = {0,          1,          2,          31,
                                         32,         0x7FFFFFFF, 0x80000000, 0xFFFFFFFF,
                                         0xFFFFFFFE, 0x80000001, 0x00FFFFFF, 0x01000001};
    return below(2) ? any() : SPECIAL[below(std::size(SPECIAL))];
}

std::uint32_t RandomCode::special_float() {
    constexpr std::uint32_t SPECIAL[] = {
        0,          0x80000000, 0x3F800000, 0xBF800000, 0x7F800000, 0xFF800000, 0x7FC00000,
        0x7F800001, 0xFFC12345, 0x00000001, 0x807FFFFF, 0x00800000, 0x80800001, 0x7F7FFFFF,
        0x4F000000, 0xCF000000, 0x4F800000, 0x3F000000, 0x3FC00000, 0xC0200000, 0x4B000001};
    switch (below(4)) {
        case 0: return SPECIAL[below(std::size(SPECIAL))];
        case 1: return any();
        case 2: return (any() & 0x807FFFFF) | (0x70 + below(32)) << 23;      // near 1
        default: return (any() & 0x80FFFFFF) | (below(2) ? 0 : 0x7F000000);  // near the limits
    }
}

std::uint32_t RandomCode::instruction(unsigned index, unsigned count) {
    switch (below(8)) {
        case 0: return memory();
        case 1: return jump(index, count);
        case 2:
        case 3:
        case 4: return floating();
        default: return integer();
    }
}

std::uint32_t RandomCode::integer() {
    const std::uint32_t rd = target() << 7, rs1 = below(32) << 15, rs2 = below(32) << 20;
    const std::uint32_t funct3 = below(8);
    switch (below(6)) {
        case 0: return (any() & 0xFFFFF000) | rd | 0x37;
        case 1: return (any() & 0xFFFFF000) | rd | 0x17;
        case 2:
        case 3: {
            std::uint32_t imm = any() & 0xFFF00000;
            if (funct3 == 1) imm &= 0x01F00000;
            if (funct3 == 5) imm &= 0x41F00000;
            return imm | rs1 | funct3 << 12 | rd | 0x13;
        }
        case 4: return 0x02000000 | rs2 | rs1 | funct3 << 12 | rd | 0x33;
        default: {
            const std::uint32_t other = (funct3 == 0 || funct3 == 5) && below(2) ? 0x40000000 : 0;
            return other | rs2 | rs1 | funct3 << 12 | rd | 0x33;
        }
    }
}

std::uint32_t RandomCode::memory() {
    const std::uint32_t rd = target() << 7, rs2 = below(32) << 20;
    const std::uint32_t base = DATA_REG << 15;
    const auto split = [](std::uint32_t imm) {
        return (imm >> 5 & 0x7F) << 25 | (imm & 0x1F) << 7;
    };
    switch (below(6)) {
        case 0: {
            constexpr std::uint32_t WIDTHS[] = {0, 1, 2, 4, 5};
            const std::uint32_t width = WIDTHS[below(5)], imm = any() << (width & 3) & 0xFFF;
            return imm << 20 | base | width << 12 | rd | 0x03;
        }
        case 1: {
            const std::uint32_t width = below(3), imm = any() << width & 0xFFF;
            return split(imm) | rs2 | base | width << 12 | 0x23;
        }
        case 2: return (any() & 0xFFC) << 20 | base | 2 << 12 | below(32) << 7 | 0x07;
        case 3: return split(any() & 0xFFC) | rs2 | base | 2 << 12 | 0x27;
        case 4: {
            constexpr std::uint32_t KINDS[] = {0, 1, 4, 8, 12, 16, 20, 24, 28};
            return KINDS[below(9)] << 27 | rs2 | ATOMIC_REG << 15 | 2 << 12 | rd | 0x2F;
        }
        default: return 2u << 27 | ATOMIC_REG << 15 | 2 << 12 | rd | 0x2F;  // LR
    }
}

// Over the next instruction, where there is one.
std::uint32_t RandomCode::jump(unsigned index, unsigned count) {
    const std::uint32_t rd = target() << 7;
    if (index + 1 == count) return 0x13;
    switch (below(4)) {
        case 0: return 8u << 20 | rd | 0x6F;
        case 1: return (index + 3) * 4 << 20 | CODE_REG << 15 | rd | 0x67;
        default: {
            constexpr std::uint32_t KINDS[] = {0, 1, 4, 5, 6, 7};
            return below(32) << 20 | below(32) << 15 | KINDS[below(6)] << 12 | 8 << 7 | 0x63;
        }
    }
}

std::uint32_t RandomCode::floating() {
    const std::uint32_t rd = below(32) << 7, rs1 = below(32) << 15, rs2 = below(32) << 20;
    const std::uint32_t to_integer = target() << 7;
    constexpr std::uint32_t MODES[] = {0, 1, 2, 3, 4, 7, 7, 7};
    const std::uint32_t mode = MODES[below(8)] << 12;
    switch (below(10)) {
        case 0: return 0x00000053 | rs2 | rs1 | mode | rd;
        case 1: return 0x08000053 | rs2 | rs1 | mode | rd;
        case 2: return 0x10000053 | rs2 | rs1 | mode | rd;
        case 3: return 0x18000053 | rs2 | rs1 | mode | rd;
        case 4: return 0x58000053 | rs1 | mode | rd;
        case 5: return (0x43 + below(4) * 4) | below(32) << 27 | rs2 | rs1 | mode | rd;
        case 6: return 0x20000053 | rs2 | rs1 | below(3) << 12 | rd;
        case 7: return 0xA0000053 | rs2 | rs1 | below(3) << 12 | to_integer;
        case 8: return 0xC0000053 | below(2) << 20 | rs1 | mode | to_integer;
        default:
            switch (below(4)) {
                case 0: return 0xE0000053 | rs1 | to_integer;
                case 1: return 0xE0001053 | rs1 | to_integer;
                case 2: return 0xF0000053 | rs1 | rd;
                default: return 0xD0000053 | below(2) << 20 | rs1 | mode | rd;
            }
    }
}

}  // namespace tb::riscv
