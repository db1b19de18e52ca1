// de10_lite.h - the C++ view of de10_lite.def: the DE10-Lite Computer's map, as regmap.h has the
// DE1-SoC Computer's.
#pragma once

#include <cstdint>
#include <iterator>

#include "regmap.h"

namespace regmap::de10_lite {

struct Line {
    const char* block;
    unsigned number;  // of mie and mip
};

constexpr bool are_same(const char* a, const char* b) {
    for (; *a && *a == *b; ++a, ++b) {
    }
    return *a == *b;
}

// The DE1-SoC Computer's block of that name, which there is.
constexpr const Block& same(const char* name) {
    const Block* block = std::begin(BLOCKS);
    while (!are_same(block->name, name)) ++block;
    return *block;
}

#define SAME(b)
#define BLOCK(b, base, size, text)
#define REG(b, r, offset, access, reset, text)
#define FIELD(b, r, f, lsb, width, text)
#define LINE(b, number)

// ARDUINO_BASE, ARDUINO_SIZE
#undef BLOCK
#define BLOCK(b, base, size, text) constexpr std::uint32_t b##_BASE = base, b##_SIZE = size;
#include "de10_lite.def"
#undef BLOCK
#define BLOCK(b, base, size, text)

// ARDUINO_DATA, ARDUINO_DATA_RESET
#undef REG
#define REG(b, r, offset, access, reset, text) \
    constexpr std::uint32_t b##_##r = b##_BASE + offset, b##_##r##_RESET = reset;
#include "de10_lite.def"
#undef REG
#define REG(b, r, offset, access, reset, text)

// ARDUINO_LINE
#undef LINE
#define LINE(b, number) constexpr unsigned b##_LINE = number;
#include "de10_lite.def"
#undef LINE
#define LINE(b, number)

constexpr Block OWN_AND_SAME[] = {
#undef SAME
#undef BLOCK
#define SAME(b) same(#b),
#define BLOCK(b, base, size, text) {#b, base, size, text},
#include "de10_lite.def"
#undef SAME
#undef BLOCK
#define SAME(b)
#define BLOCK(b, base, size, text)
};

constexpr const char* NAMES_OF_SAME[] = {
#undef SAME
#define SAME(b) #b,
#include "de10_lite.def"
#undef SAME
#define SAME(b)
};

// Of its own blocks.
constexpr Reg OWN_REGS[] = {
#undef REG
#define REG(b, r, offset, access, reset, text) {#b "_" #r, b##_##r, Access::access, reset, text},
#include "de10_lite.def"
#undef REG
#define REG(b, r, offset, access, reset, text)
};

constexpr Field OWN_FIELDS[] = {
#undef FIELD
#define FIELD(b, r, f, lsb, width, text) {#b "_" #r, #f, lsb, width, text},
#include "de10_lite.def"
#undef FIELD
#define FIELD(b, r, f, lsb, width, text)
};

constexpr Line LINES[] = {
#undef LINE
#define LINE(b, number) {#b, number},
#include "de10_lite.def"
};
#undef SAME
#undef BLOCK
#undef REG
#undef FIELD
#undef LINE

constexpr bool is_same(const Block& block) {
    for (const char* name : NAMES_OF_SAME)
        if (are_same(name, block.name)) return true;
    return false;
}

constexpr bool blocks_are_apart() {
    for (auto a = std::begin(OWN_AND_SAME); a != std::end(OWN_AND_SAME); ++a)
        for (auto b = a + 1; b != std::end(OWN_AND_SAME); ++b)
            if (a->base < b->base + b->size && b->base < a->base + a->size) return false;
    return true;
}
static_assert(blocks_are_apart(), "two blocks overlap");

// The block at an address; null: none.
constexpr const Block* block_at(std::uint32_t address) {
    for (const Block& block : OWN_AND_SAME)
        if (address - block.base < block.size) return &block;
    return nullptr;
}

// Whether a block, which is no memory, can be written.
constexpr bool takes_writes(const Block& block) {
    if (is_same(block)) return regmap::takes_writes(block);
    for (const Reg& r : OWN_REGS)
        if (r.addr - block.base < block.size && r.access != Access::RO) return true;
    return false;
}

}  // namespace regmap::de10_lite
