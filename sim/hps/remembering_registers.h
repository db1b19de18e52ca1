// remembering_registers.h - blocks that only need to exist for programs: some registers keep what
// was written and do nothing, others always read the same.
//
//   scu             0xFFFEC000  enable remembers; configuration: two processors, 32 KB caches
//   l2_cache        0xFFFEF000  L2C-310: 512 KB, 8 ways; maintenance is complete at once
//   system_manager  0xFFD08000  silicon ID of a Cyclone V; the rest remembers
//   l3              0xFF800000  remap and security bits remember
//   sdram_control   0xFFC20000  the DDR3's controller, calibrated, as the preloader leaves it
//   scan_manager    0xFFF02000  idle, its FIFOs empty
//
// Not handled: what the bits would do.
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "sim/hps/registers.h"

namespace sim {

// A range of read-only registers that all read `value`.
struct FixedRegisters {
    std::uint32_t first, last, value;
};

class RememberingRegisters : public Registers {
public:
    // Registers that are neither fixed nor in `reset` read 0 until they are written.
    RememberingRegisters(const sc_core::sc_module_name& module_name,
                         std::vector<FixedRegisters> fixed,
                         std::map<std::uint32_t, std::uint32_t> reset = {})
        : Registers{module_name}, fixed_{std::move(fixed)}, values_{std::move(reset)} {}

    std::uint32_t value(std::uint32_t offset) const {
        for (const FixedRegisters& range : fixed_)
            if (offset >= range.first && offset <= range.last) return range.value;
        const auto found = values_.find(offset);
        return found == values_.end() ? 0 : found->second;
    }

private:
    std::uint32_t read(std::uint32_t offset, const sc_core::sc_time&) override {
        return value(offset);
    }
    void write(std::uint32_t offset, std::uint32_t value, const sc_core::sc_time&) override {
        values_[offset] = value;
    }

    const std::vector<FixedRegisters> fixed_;
    std::map<std::uint32_t, std::uint32_t> values_;
};

// The tables of the blocks above.
namespace remembering {
std::vector<FixedRegisters> scu();
std::vector<FixedRegisters> l2_cache();
std::map<std::uint32_t, std::uint32_t> l2_cache_after_preloader();
std::vector<FixedRegisters> system_manager();
std::vector<FixedRegisters> sdram_control();
std::map<std::uint32_t, std::uint32_t> sdram_after_preloader();
std::vector<FixedRegisters> scan_manager();
}  // namespace remembering

}  // namespace sim
