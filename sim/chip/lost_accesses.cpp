#include "sim/chip/lost_accesses.h"

#include <algorithm>

#include <fmt/format.h>

#include "regmap.h"

namespace sim {

namespace {

constexpr std::uint32_t LW_MASK = regmap::LW_DECODED - 1;
constexpr std::uint32_t H2F_DECODED = 0x10000000, H2F_MASK = H2F_DECODED - 1;

const regmap::Block& block_of(std::uint32_t address) {
    return *std::find_if(std::begin(regmap::BLOCKS), std::end(regmap::BLOCKS),
                         [&](const regmap::Block& b) { return address - b.base < b.size; });
}

// "TIMER0_STATUS", "TIMER0, where it has no register"
std::string name_of(std::uint32_t address) {
    for (const regmap::Reg& reg : regmap::REGS)
        if (reg.addr == (address & ~3u)) return reg.name;
    return std::string{block_of(address).name} + ", where it has no register";
}

// The memory at an offset of the full bridge, as far as it is decoded; none: nullptr.
const regmap::Block* memory_at(std::uint32_t offset) {
    for (const regmap::Block& block : regmap::BLOCKS)
        if (!regmap::on_lightweight_bridge(block) &&
            offset - (block.base - regmap::SDRAM_BASE) < block.size)
            return &block;
    return nullptr;
}

// Where the gap around an offset begins, as a place to speak of once.
std::uint32_t gap_begin(std::uint32_t address) {
    std::uint32_t begin = 0;
    for (const regmap::Block& block : regmap::BLOCKS)
        if (block.base + block.size <= address) begin = std::max(begin, block.base + block.size);
    return begin;
}

}  // namespace

LostAccesses::LostAccesses(std::uint32_t memory_base, bool has_jp2)
    : memory_base_{memory_base}, words_(regmap::LW_DECODED / 4, NOBODY) {
    for (const regmap::Block& block : regmap::BLOCKS)
        if (regmap::on_lightweight_bridge(block))
            std::fill_n(words_.begin() + (block.base - regmap::LW_BASE) / 4,
                        std::max(1u, block.size / 4),
                        regmap::takes_writes(block) ? NOTHING : READ_ALONE);
    for (const regmap::Reg& reg : regmap::REGS) {
        Word& word = words_[(reg.addr - regmap::LW_BASE) / 4];
        if (word == NOTHING) word = reg.access == regmap::Access::RO ? READ_ONLY : READ_WRITE;
    }
    if (!has_jp2)
        std::fill_n(words_.begin() + (regmap::JP2_BASE - regmap::LW_BASE) / 4, regmap::JP2_SIZE / 4,
                    NOBODY);
}

std::optional<std::string> LostAccesses::look(std::uint32_t address, unsigned bytes, bool write) {
    if (address - regmap::LW_BASE >= regmap::LW_SIZE) {
        const std::uint32_t offset = address - memory_base_;
        const regmap::Block* whole = memory_at(offset);
        if (whole && memory_at(offset + bytes - 1) == whole) return std::nullopt;
        for (std::uint32_t at = address; at < address + bytes; at = (at & ~3u) + 4)
            if (!memory_at(at - memory_base_)) return memory(at, write);
        return std::nullopt;
    }
    for (std::uint32_t at = address & ~3u; at < address + bytes; at += 4) {
        const std::uint32_t offset = at - regmap::LW_BASE;
        const Word word = words_[(offset & LW_MASK) / 4];
        const bool lost = write ? word != READ_WRITE : word == NOTHING || word == NOBODY;
        if (lost || offset > LW_MASK) return registers(at, write, word);
    }
    return std::nullopt;
}

std::optional<std::string> LostAccesses::memory(std::uint32_t address, bool write) {
    const std::uint32_t offset = address - memory_base_, local = offset & H2F_MASK;
    const regmap::Block* block = memory_at(local);
    const std::uint32_t again = offset & ~H2F_MASK;
    const std::uint32_t place =
        again ? address & ~H2F_MASK : gap_begin(regmap::SDRAM_BASE + offset);
    if (!is_new(place, write)) return std::nullopt;
    const char* did = write ? "wrote" : "read";
    if (block)
        return fmt::format(
            "{} 0x{:08X}: addresses repeat each {} MB; on the board, too, it is {} at "
            "0x{:08X}",
            did, address, H2F_DECODED >> 20, block->name, memory_base_ + local);
    return fmt::format(
        "{} 0x{:08X}: no memory is there; on the board, too, the interconnect sends it "
        "to the SDRAM at 0x{:08X}",
        did, address, memory_base_ + local % regmap::SDRAM_SIZE);
}

std::optional<std::string> LostAccesses::registers(std::uint32_t address, bool write, Word word) {
    const std::uint32_t local = regmap::LW_BASE + ((address - regmap::LW_BASE) & LW_MASK);
    const bool again = local != address, nobody = word == NOBODY || (write && word == READ_ALONE);
    const std::uint32_t place = again            ? address & ~LW_MASK
                                : word == NOBODY ? gap_begin(local)
                                                 : block_of(local).base;
    if (!is_new(place, write)) return std::nullopt;
    const std::string what = fmt::format("{} 0x{:08X}: ", write ? "wrote" : "read", address);
    if (nobody) {
        const regmap::Block& other = regmap::lw_default();
        const std::string why = word == NOBODY
                                    ? "no block is there"
                                    : fmt::format("{} cannot be written", name_of(local));
        return what + why + "; on the board, too, the interconnect sends it to " +
               name_of(other.base + local % other.size);
    }
    if (again)
        return what + fmt::format("addresses repeat each {} KB; on the board, too, it is {}",
                                  regmap::LW_DECODED / 1024, name_of(local));
    const char* lost = write ? "the write is lost" : "it reads 0";
    if (word == READ_ONLY) return what + fmt::format("{} is read-only; {}", name_of(local), lost);
    return what + fmt::format("{} has no register there; {}", block_of(local).name, lost);
}

}  // namespace sim
