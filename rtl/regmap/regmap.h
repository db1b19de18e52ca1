// regmap.h - the C++ view of regmap.def: addresses, resets, field masks, interrupt IDs.
//
// A register has one name everywhere: AUDIO_CONTROL is a constant here, a localparam in regmap.vh
// and a row in REGISTERS.md, so one grep finds the RTL, the driver, the model and the tests.
#pragma once

#include <cstdint>
#include <iterator>

namespace regmap {

enum class Access { RO, RW, WO };

struct Block {
    const char* name;
    std::uint32_t base, size;  // bytes
    const char* text;
};

struct Reg {
    const char* name;
    std::uint32_t addr;  // as the processor sees it
    Access access;
    std::uint32_t reset;
    const char* text;
};

struct Field {
    const char *reg, *name;
    unsigned lsb, width;
    const char* text;
};

#define BLOCK(b, base, size, text)
#define REG(b, r, offset, access, reset, text)
#define FIELD(b, r, f, lsb, width, text)
#define IRQ(name, id)

// AUDIO_BASE, AUDIO_SIZE
#undef BLOCK
#define BLOCK(b, base, size, text) constexpr std::uint32_t b##_BASE = base, b##_SIZE = size;
#include "regmap.def"
#undef BLOCK
#define BLOCK(b, base, size, text)

// AUDIO_CONTROL, AUDIO_CONTROL_RESET
#undef REG
#define REG(b, r, offset, access, reset, text) \
    constexpr std::uint32_t b##_##r = b##_BASE + offset, b##_##r##_RESET = reset;
#include "regmap.def"
#undef REG
#define REG(b, r, offset, access, reset, text)

// AUDIO_CONTROL_RE_LSB, AUDIO_CONTROL_RE_MASK (the mask is already shifted)
#undef FIELD
#define FIELD(b, r, f, lsb, width, text)               \
    constexpr std::uint32_t b##_##r##_##f##_LSB = lsb; \
    constexpr std::uint32_t b##_##r##_##f##_MASK = ((std::uint64_t{1} << (width)) - 1) << (lsb);
#include "regmap.def"
#undef FIELD
#define FIELD(b, r, f, lsb, width, text)

// AUDIO_IRQ_ID
#undef IRQ
#define IRQ(name, id) constexpr unsigned name##_IRQ_ID = id;
#include "regmap.def"
#undef IRQ
#define IRQ(name, id)

constexpr Block BLOCKS[] = {
#undef BLOCK
#define BLOCK(b, base, size, text) {#b, base, size, text},
#include "regmap.def"
#undef BLOCK
#define BLOCK(b, base, size, text)
};

constexpr Reg REGS[] = {
#undef REG
#define REG(b, r, offset, access, reset, text) {#b "_" #r, b##_##r, Access::access, reset, text},
#include "regmap.def"
#undef REG
#define REG(b, r, offset, access, reset, text)
};

constexpr Field FIELDS[] = {
#undef FIELD
#define FIELD(b, r, f, lsb, width, text) {#b "_" #r, #f, lsb, width, text},
#include "regmap.def"
#undef FIELD
#define FIELD(b, r, f, lsb, width, text)
};

// ---- What a reviewer would otherwise have to check by eye ----

#undef BLOCK
#undef REG
#undef FIELD
#undef IRQ
#define BLOCK(b, base, size, text)                                             \
    static_assert(((size) & ((size)-1)) == 0, #b ": size not a power of two"); \
    static_assert((base) % (size) == 0, #b ": base not aligned to size");
#define REG(b, r, offset, access, reset, text)                        \
    static_assert((offset) % 4 == 0, #b "_" #r ": not word aligned"); \
    static_assert((offset) < b##_SIZE, #b "_" #r ": outside its block");
#define FIELD(b, r, f, lsb, width, text) \
    static_assert((lsb) + (width) <= 32, #b "_" #r "_" #f ": past bit 31");
#define IRQ(name, id) static_assert((id) >= 72 && (id) < 136, #name ": not an FPGA interrupt");
#include "regmap.def"
#undef BLOCK
#undef REG
#undef FIELD
#undef IRQ

constexpr bool registers_are_apart() {
    for (auto a = std::begin(REGS); a != std::end(REGS); ++a)
        for (auto b = a + 1; b != std::end(REGS); ++b)
            if (a->addr == b->addr) return false;
    return true;
}
static_assert(registers_are_apart(), "two registers share an address");

constexpr bool blocks_are_apart() {
    for (auto a = std::begin(BLOCKS); a != std::end(BLOCKS); ++a)
        for (auto b = a + 1; b != std::end(BLOCKS); ++b)
            if (a->base < b->base + b->size && b->base < a->base + a->size) return false;
    return true;
}
static_assert(blocks_are_apart(), "two blocks overlap");

// ---- Select lines of the lightweight bridge ----

constexpr std::uint32_t LW_BASE = 0xFF200000, LW_SIZE = 0x00200000;
constexpr int LW_SELECTS = 32;  // number of select lines

constexpr bool on_lightweight_bridge(const Block& block) { return block.base - LW_BASE < LW_SIZE; }

// The block's select line: lines are numbered in the order of the blocks in regmap.def.
constexpr int select(const Block& block) {
    int lines = 0;
    for (const Block* before = BLOCKS; before != &block; ++before)
        lines += on_lightweight_bridge(*before);
    return lines;
}
static_assert(select(*(std::end(BLOCKS) - 1)) < LW_SELECTS, "more blocks than select lines");

// ---- Where the interconnect sends an address of that bridge ----

// Bits above are not looked at, so addresses repeat: a power of two after the last block.
constexpr std::uint32_t lw_decoded() {
    std::uint32_t end = 0, size = 1;
    for (const Block& b : BLOCKS)
        if (on_lightweight_bridge(b) && b.base - LW_BASE + b.size > end)
            end = b.base - LW_BASE + b.size;
    while (size < end) size *= 2;
    return size;
}
constexpr std::uint32_t LW_DECODED = lw_decoded();

// The block that gets what no other block takes: that with the largest span, of equals the first.
constexpr const Block& lw_default() {
    const Block* found = nullptr;
    for (const Block& b : BLOCKS)
        if (on_lightweight_bridge(b) &&
            (!found || b.size > found->size || (b.size == found->size && b.base < found->base)))
            found = &b;
    return *found;
}

// A block that can only be read takes no writes.
constexpr bool takes_writes(const Block& block) {
    for (const Reg& r : REGS)
        if (r.addr - block.base < block.size && r.access != Access::RO) return true;
    return false;
}

// FNV-1a over every name, address, access, reset, field and interrupt: what SYSID_HASH reads.
constexpr std::uint32_t hash() {
    std::uint32_t h = 2166136261u;
    const auto byte = [&h](unsigned b) { h = (h ^ (b & 0xffu)) * 16777619u; };
    const auto word = [&byte](std::uint32_t w) {
        for (int i = 0; i < 4; ++i) byte(w >> (8 * i));
    };
    const auto text = [&byte](const char* s) {
        for (; *s; ++s) byte(static_cast<unsigned char>(*s));
        byte(0);
    };
    for (const Block& b : BLOCKS) text(b.name), word(b.base), word(b.size);
    for (const Reg& r : REGS)
        text(r.name), word(r.addr), word(static_cast<std::uint32_t>(r.access)), word(r.reset);
    for (const Field& f : FIELDS) text(f.reg), text(f.name), word(f.lsb), word(f.width);
#define BLOCK(b, base, size, text)
#define REG(b, r, offset, access, reset, text)
#define FIELD(b, r, f, lsb, width, text)
#define IRQ(name, id) text(#name), word(id);
#include "regmap.def"
#undef BLOCK
#undef REG
#undef FIELD
#undef IRQ
    return h;
}
constexpr std::uint32_t REGMAP_HASH = hash();

}  // namespace regmap
