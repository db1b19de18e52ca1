#include "sim/chip/lost_accesses.h"

#include <algorithm>

#include <fmt/format.h>

#include "regmap.h"

namespace sim {

namespace {

constexpr std::uint32_t ONCHIP_END = regmap::ONCHIP_BASE + regmap::ONCHIP_SIZE;

const regmap::Block& block_of(std::uint32_t address) {
    return *std::find_if(std::begin(regmap::BLOCKS), std::end(regmap::BLOCKS),
                         [&](const regmap::Block& b) { return address - b.base < b.size; });
}

const char* name_of(std::uint32_t address) {
    return std::find_if(std::begin(regmap::REGS), std::end(regmap::REGS),
                        [&](const regmap::Reg& reg) { return reg.addr == address; })
        ->name;
}

}  // namespace

// Addresses between the blocks answer with an error.
LostAccesses::LostAccesses() : words_(regmap::LW_SIZE / 4, READ_WRITE) {
    for (const regmap::Block& block : regmap::BLOCKS)
        if (regmap::on_lightweight_bridge(block))
            std::fill_n(words_.begin() + (block.base - regmap::LW_BASE) / 4, block.size / 4,
                        NOTHING);
    for (const regmap::Reg& reg : regmap::REGS)
        words_[(reg.addr - regmap::LW_BASE) / 4] =
            reg.access == regmap::Access::RO ? READ_ONLY : READ_WRITE;
}

std::optional<std::string> LostAccesses::look(std::uint32_t address, unsigned bytes, bool write) {
    if (address - regmap::LW_BASE >= regmap::LW_SIZE) {
        const std::uint32_t last = address + bytes - 1;
        if (last < ONCHIP_END || address - regmap::ONCHIP_BASE >= 2 * regmap::ONCHIP_SIZE)
            return std::nullopt;
        return say(std::max(address, ONCHIP_END), write, NOTHING);
    }
    for (std::uint32_t at = address & ~3u; at < address + bytes; at += 4) {
        const Word word = words_[(at - regmap::LW_BASE) / 4];
        if (word != READ_WRITE && (write || word == NOTHING)) return say(at, write, word);
    }
    return std::nullopt;
}

std::optional<std::string> LostAccesses::say(std::uint32_t address, bool write, Word word) {
    const bool memory = address - regmap::LW_BASE >= regmap::LW_SIZE;
    const std::uint32_t place = memory ? ONCHIP_END : block_of(address).base;
    if (!said_.insert({place, write}).second) return std::nullopt;
    const std::string what = fmt::format("{} 0x{:08X}: ", write ? "wrote" : "read", address);
    const char* lost = write ? "the write is lost" : "it reads 0";
    if (memory)
        return what + fmt::format(
                          "the on-chip memory ends at 0x{:08X}; {}, on the board it would "
                          "{} the SDRAM at 0x{:08X}",
                          ONCHIP_END - 1, lost, write ? "change" : "be of",
                          regmap::SDRAM_BASE + address % regmap::SDRAM_SIZE);
    if (word == READ_ONLY) return what + fmt::format("{} is read-only; {}", name_of(address), lost);
    return what + fmt::format("{} has no register there; {}", block_of(address).name, lost);
}

}  // namespace sim
