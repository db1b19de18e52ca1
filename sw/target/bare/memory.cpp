// memory.cpp - see memory.h.  ARM Architecture Reference Manual ARMv7-A, B3.5: short descriptors.
#include "memory.h"

#include <cstdint>

#include "regmap.h"

namespace {

constexpr std::uint32_t MEGABYTE = 1u << 20;
constexpr std::uint32_t DDR3_SIZE = 0x40000000;

// A section of 1 MB, full access, domain 0.
constexpr std::uint32_t SECTION = 2 | 3u << 10, XN = 1u << 4, B = 1u << 2, C = 1u << 3,
                        TEX_1 = 1u << 12;
constexpr std::uint32_t CACHED = SECTION | TEX_1 | C | B;  // write-back, write-allocate
constexpr std::uint32_t UNCACHED = SECTION | TEX_1 | XN;   // Normal, bufferable
constexpr std::uint32_t DEVICE = SECTION | B | XN;         // Device, shareable

alignas(16 * 1024) std::uint32_t table[4096];

std::uint32_t attributes(std::uint32_t base) {
    if (base < DDR3_SIZE) return CACHED;
    if (base - regmap::SDRAM_BASE < regmap::SDRAM_SIZE || base == regmap::ONCHIP_BASE)
        return UNCACHED;
    return DEVICE;
}

// The L2 cache controller, PL310: nothing to do if a boot loader has switched it on.
void second_level_on() {
    const auto reg = [](std::uint32_t offset) -> volatile std::uint32_t& {
        return *reinterpret_cast<volatile std::uint32_t*>(0xFFFEF000 + offset);
    };
    constexpr std::uint32_t CONTROL = 0x100, INVALIDATE_WAY = 0x77C, SYNC = 0x730, ALL_WAYS = 0xff;
    if (reg(CONTROL) & 1) return;
    reg(INVALIDATE_WAY) = ALL_WAYS;
    for (unsigned i = 0; i < 1'000'000 && reg(INVALIDATE_WAY) & ALL_WAYS; ++i) {
    }
    reg(SYNC) = 0;
    reg(CONTROL) = 1;
}

}  // namespace

void memory_on() {
    for (std::uint32_t i = 0; i < 4096; ++i) table[i] = i * MEGABYTE | attributes(i * MEGABYTE);
    second_level_on();

    const auto base = reinterpret_cast<std::uintptr_t>(table);
    asm volatile(
        "mcr p15, 0, %[zero], c2, c0, 2 \n"    // TTBCR: one table
        "mcr p15, 0, %[base], c2, c0, 0 \n"    // TTBR0, walks not cached
        "mcr p15, 0, %[client], c3, c0, 0 \n"  // DACR: domain 0 is a client, so XN counts
        "dsb \n isb \n"
        "mrc p15, 0, r1, c1, c0, 0 \n"
        "orr r1, r1, #0x1800 \n"  // Z, I
        "orr r1, r1, #0x5 \n"     // C, M
        "mcr p15, 0, r1, c1, c0, 0 \n"
        "isb \n"
        :
        : [zero] "r"(0), [base] "r"(base), [client] "r"(1)
        : "r1", "memory");
}
