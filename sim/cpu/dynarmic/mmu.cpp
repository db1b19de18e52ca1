#include "sim/cpu/dynarmic/mmu.h"

#include <algorithm>
#include <cstring>

namespace sim {

void Mmu::map(const MemoryMap::Area& area) {
    memory_.add(area);
    forget();
}

void Mmu::unmap(std::uint32_t base) {
    memory_.remove(base);
    forget();
}

void Mmu::look_up(std::uint32_t address, Page& page) const {
    const Translation to = walk(address & ~0xFFFu, cpu_.privileged());
    page = {};
    page.status = to.status;
    page.access = to.access;
    page.normal = to.normal;
    page.cache = static_cast<std::uint8_t>(axi_cache(to));
    page.no_code = !(to.access & arm_access::EXECUTE);
    if (to.access == 0) return;  // which is not cached, as in a TLB (B3.9.1)
    page.number = address >> 12;
    const MemoryMap::Area* const area = memory_.find(to.physical);
    if (!area) {
        page.access = 0;
        page.status = 0x5;  // translation fault
        return;
    }
    page.access &= area->access;
    page.normal |= (area->access & arm_access::NORMAL) != 0;
    const std::uint32_t offset = to.physical - area->base;
    page.physical = area->bytes ? to.physical : area->bus_base + offset;
    page.code = area->bytes ? area->bytes + offset : nullptr;
    page.bytes = area->bytes && !area->data_by_bus ? area->bytes + offset : nullptr;
}

void Mmu::permit_code(std::uint32_t base, std::uint32_t size) {
    forbidden_.erase(std::remove(forbidden_.begin(), forbidden_.end(), std::pair{base, size}),
                     forbidden_.end());
}

bool Mmu::is_forbidden(std::uint32_t address) const {
    for (const auto& [base, size] : forbidden_)
        if (address - base < size) return true;
    return false;
}

std::optional<std::uint16_t> Mmu::half_of_code(std::uint32_t address) {
    if (is_forbidden(address)) return std::nullopt;
    const Page& at = page(address);
    if (!at.may_execute()) return std::nullopt;
    std::uint16_t half;
    std::memcpy(&half, at.code + (address & 0xFFE), sizeof half);
    return half;
}

}  // namespace sim
