// memory.cpp - ArmCore's memory: what is mapped where, and RAM seen from outside.
#include <algorithm>

#include "sim/cpu/unicorn/engine.h"

namespace sim {

void ArmCore::map_ram(std::uint32_t base, std::uint64_t size, void* bytes, unsigned access,
                      bool /*data_by_bus*/) {
    check_uc(uc_mem_map_ptr(engine_->uc, base, size, access & UC_PROT_ALL, bytes), "map of RAM");
    engine_->ram.push_back({base, size, static_cast<std::uint8_t*>(bytes)});
}

void ArmCore::unmap(std::uint32_t base, std::uint64_t size) {
    check_uc(uc_mem_unmap(engine_->uc, base, size), "unmapping");
    auto& ram = engine_->ram;
    ram.erase(std::remove_if(ram.begin(), ram.end(),
                             [base](const Engine::Ram& area) { return area.base == base; }),
              ram.end());
    auto& windows = engine_->windows;
    windows.erase(std::remove_if(windows.begin(), windows.end(),
                                 [base](const auto& window) { return window->base == base; }),
                  windows.end());
}

void ArmCore::forbid_code(std::uint32_t base, std::uint32_t size) {
    engine_->forbidden.emplace_back(base, size);
}

void ArmCore::permit_code(std::uint32_t base, std::uint32_t size) {
    auto& all = engine_->forbidden;
    all.erase(std::remove(all.begin(), all.end(), std::pair{base, size}), all.end());
}

std::optional<std::uint32_t> ArmCore::bus_address(std::uint32_t address) const {
    for (const auto& window : engine_->windows)
        if (address - window->base < window->size)
            return window->bus_base + (address - window->base);
    return std::nullopt;
}

bool ArmCore::read_ram(std::uint32_t address, void* data, std::size_t bytes) const {
    const Engine::Ram* area = engine_->find(address, bytes);
    if (area)
        std::copy_n(area->bytes + (address - area->base), bytes, static_cast<std::uint8_t*>(data));
    return area != nullptr;
}

bool ArmCore::write_ram(std::uint32_t address, const void* data, std::size_t bytes) {
    const Engine::Ram* area = engine_->find(address, bytes);
    if (!area) return false;
    std::copy_n(static_cast<const std::uint8_t*>(data), bytes,
                area->bytes + (address - area->base));
    forget_translations(address, bytes);
    return true;
}

void ArmCore::forget_translations(std::uint32_t address, std::size_t bytes) {
    uc_ctl_remove_cache(engine_->uc, address, address + bytes);
}

}  // namespace sim
