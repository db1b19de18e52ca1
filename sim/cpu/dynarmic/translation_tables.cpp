#include "sim/cpu/dynarmic/translation_tables.h"

#include <cstring>
#include <optional>

namespace sim {

namespace {

constexpr std::uint32_t SCTLR_TRE = 1u << 28, SCTLR_AFE = 1u << 29;
constexpr std::uint32_t TTBCR_PD0 = 1u << 4, TTBCR_PD1 = 1u << 5;
constexpr Cp15 PRRR{10, 0, 2, 0}, NMRR{10, 0, 2, 1};
constexpr std::uint32_t PAR_SUPERSECTION = 2, PAR_SHAREABLE = 1 << 7;

// DFSR's and IFSR's status; the page's is the section's + 2.
constexpr std::uint32_t TRANSLATION = 0x5, ACCESS_FLAG_SECTION = 0x3, ACCESS_FLAG_PAGE = 0x6,
                        DOMAIN = 0x9, PERMISSION = 0xD, EXTERNAL_WALK_1 = 0xC,
                        EXTERNAL_WALK_2 = 0xE;

std::optional<std::uint32_t> word_at(const MemoryMap& memory, std::uint32_t address) {
    const std::uint8_t* const bytes = memory.ram(address, 4);
    if (!bytes) return std::nullopt;
    std::uint32_t word;
    std::memcpy(&word, bytes, 4);
    return word;
}

// AP[2:0] to arm_access, without EXECUTE (B3.7.1).
unsigned permitted(unsigned ap, bool privileged, bool access_flag) {
    using namespace arm_access;
    if (access_flag) ap = (ap & 0b110) | 1;  // AP[0] is the flag; the model has AP[2:1] alone
    switch (ap) {
        case 0b001: return privileged ? READ | WRITE : 0;
        case 0b010: return privileged ? READ | WRITE : READ;
        case 0b011: return READ | WRITE;
        case 0b101: return privileged ? READ : 0;
        case 0b110:
        case 0b111: return READ;
        default: return 0;
    }
}

struct Memory {
    bool normal;
    std::uint32_t par;  // inner attributes in 6:4, outer ones in 3:2
};

constexpr std::uint32_t STRONGLY_ORDERED = 0b001 << 4, DEVICE = 0b011 << 4;

// Cacheability as in TEX[1:0], C and B, and in NMRR (B3.8.2): not, write-back allocating,
// write-through, write-back.
constexpr std::uint32_t INNER[] = {0b000, 0b101, 0b110, 0b111};
constexpr std::uint32_t cached(unsigned inner, unsigned outer) {
    return INNER[inner] << 4 | outer << 2;
}

// TEX, C and B to the memory's type (B3.8.2, B3.8.3; PRRR, NMRR: B4.1.127).
Memory memory_of(const Cp15Registers& cp15, unsigned tex, unsigned cb) {
    if (cp15.value(cp15::SCTLR) & SCTLR_TRE) {
        const unsigned n = (tex & 1) << 2 | cb;
        const std::uint32_t nmrr = cp15.value(NMRR);
        switch (cp15.value(PRRR) >> 2 * n & 3) {
            case 0: return {false, STRONGLY_ORDERED};
            case 1: return {false, DEVICE};
            case 2: return {true, cached(nmrr >> 2 * n & 3, nmrr >> (16 + 2 * n) & 3)};
            default: return {false, 0};
        }
    }
    if (tex >= 4) return {true, cached(cb, tex & 3)};
    switch (tex << 2 | cb) {
        case 0b00000: return {false, STRONGLY_ORDERED};
        case 0b00001:
        case 0b01000: return {false, DEVICE};
        case 0b00010:
        case 0b00011: return {true, cached(cb, cb)};
        case 0b00100: return {true, cached(0, 0)};
        case 0b00111: return {true, cached(1, 1)};
        default: return {false, 0};
    }
}

}  // namespace

Translation translate(const Cp15Registers& cp15, const MemoryMap& memory, std::uint32_t address,
                      bool privileged) {
    const std::uint32_t control = cp15.value(cp15::SCTLR);
    if (!(control & SCTLR_M)) return {address, arm_access::ALL, 0, false, STRONGLY_ORDERED};

    const std::uint32_t split = cp15.value(cp15::TTBCR), n = split & 7;
    const bool second_table = n != 0 && address >> (32 - n) != 0;
    if (split & (second_table ? TTBCR_PD1 : TTBCR_PD0)) return {0, 0, TRANSLATION};
    const std::uint32_t base = second_table ? cp15.value(cp15::TTBR1) & ~0x3FFFu
                                            : cp15.value(cp15::TTBR0) & ~((1u << (14 - n)) - 1);
    const std::uint32_t index = second_table ? address >> 20 : (address << n >> n) >> 20;
    const auto first = word_at(memory, base + 4 * index);
    if (!first) return {0, 0, EXTERNAL_WALK_1};

    const std::uint32_t kind = *first & 3;
    if (kind == 0 || kind == 3) return {0, 0, TRANSLATION};
    const bool section = kind == 2, super = section && (*first >> 18 & 1);
    const std::uint32_t domain = super ? 0 : *first >> 5 & 0xF;
    const std::uint32_t in_status = domain << 4, level = section ? 0 : 2;

    std::uint32_t physical;
    unsigned ap;
    bool never, shareable;
    Memory type;
    if (section) {
        const std::uint32_t inside = super ? 0x00FFFFFF : 0x000FFFFF;
        physical = (*first & ~inside) | (address & inside);
        ap = (*first >> 10 & 3) | (*first >> 13 & 4);
        never = *first >> 4 & 1;
        shareable = *first >> 16 & 1;
        type = memory_of(cp15, *first >> 12 & 7, *first >> 2 & 3);
    } else {
        const auto second = word_at(memory, (*first & ~0x3FFu) + 4 * (address >> 12 & 0xFF));
        if (!second) return {0, 0, EXTERNAL_WALK_2 | in_status};
        if ((*second & 3) == 0) return {0, 0, TRANSLATION | level | in_status};
        const bool large = (*second & 3) == 1;
        const std::uint32_t inside = large ? 0xFFFF : 0xFFF;
        physical = (*second & ~inside) | (address & inside);
        ap = (*second >> 4 & 3) | (*second >> 7 & 4);
        never = large ? *second >> 15 & 1 : *second & 1;
        shareable = *second >> 10 & 1;
        type = memory_of(cp15, *second >> (large ? 12 : 6) & 7, *second >> 2 & 3);
    }

    const std::uint32_t attributes =
        type.par | (shareable ? PAR_SHAREABLE : 0) | (super ? PAR_SUPERSECTION : 0);
    const bool access_flag = control & SCTLR_AFE;
    if (access_flag && !(ap & 1))
        return {0, 0, (section ? ACCESS_FLAG_SECTION : ACCESS_FLAG_PAGE) | in_status};
    switch (cp15.value(cp15::DACR) >> (2 * domain) & 3) {
        case 1: break;
        case 3: return {physical, arm_access::ALL, 0, type.normal, attributes};
        default: return {0, 0, DOMAIN | level | in_status};
    }
    unsigned access = permitted(ap, privileged, access_flag);
    if ((access & arm_access::READ) && !never) access |= arm_access::EXECUTE;
    return {physical, access, PERMISSION | level | in_status, type.normal, attributes};
}

unsigned axi_cache(const Translation& to) {
    constexpr std::uint8_t OUTER[] = {0b0011, 0b1111, 0b0110, 0b0111};
    if (to.normal) return OUTER[to.attributes >> 2 & 3];
    return (to.attributes & DEVICE) == DEVICE ? 0b0001 : 0b0000;
}

std::uint32_t par(const Translation& to, unsigned needed) {
    constexpr std::uint32_t FAULT = 1, STATUS = 0xF, STATUS_4 = 1 << 10;
    if ((to.access & needed) != needed)
        return FAULT | (to.status & STATUS) << 1 | (to.status & STATUS_4 ? 1u << 5 : 0);
    const std::uint32_t inside = to.attributes & PAR_SUPERSECTION ? 0x00FFFFFF : 0xFFF;
    return (to.physical & ~inside) | to.attributes;
}

}  // namespace sim
