// mmu.h - what a virtual address is for the program: RAM of the host, the bus, or nothing.
//
// It joins the translation tables, what is mapped at physical addresses, and where no instruction
// may be read from.  Answers are for the present mode and tables, and are cached: who changes these
// calls forget().
#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "sim/cpu/dynarmic/cpu_state.h"
#include "sim/cpu/dynarmic/memory_map.h"
#include "sim/cpu/dynarmic/page_table.h"
#include "sim/cpu/dynarmic/translation_tables.h"

namespace sim {

class Mmu {
public:
    using Page = PageTable::Page;

    explicit Mmu(const CpuState& cpu) : cpu_{cpu} {}

    // ---- Physical addresses ----

    void map(const MemoryMap::Area& area);
    void unmap(std::uint32_t base);
    const MemoryMap& memory() const { return memory_; }

    // ---- Virtual addresses ----

    // The page around `address`, until the next call.  Costs 1 ns if it is in the cache.
    const Page& page(std::uint32_t address) {
        Page& slot = pages_.slot(address >> 12);
        if (slot.number != address >> 12) look_up(address, slot);
        return slot;
    }
    // A walk of the tables, for whatever mode.
    Translation walk(std::uint32_t address, bool privileged) const {
        return translate(cpu_.cp15, memory_, address, privileged);
    }
    // The translation tables do not keep it from the user mode; `right`: one of arm_access.
    bool user_may(std::uint32_t address, unsigned right) const {
        return walk(address, false).access & right;
    }

    // ---- Instructions ----

    void forbid_code(std::uint32_t base, std::uint32_t size) {
        forbidden_.emplace_back(base, size);
    }
    void permit_code(std::uint32_t base, std::uint32_t size);
    bool is_forbidden(std::uint32_t address) const;
    // 16 bits; nothing where no instruction can be read from.
    std::optional<std::uint16_t> half_of_code(std::uint32_t address);

    // ---- What translated code accesses by itself ----

    PageTable::Direct* direct() { return pages_.direct(); }
    void open(const Page& page) { pages_.open(page.number, page.bytes); }
    void close(const Page& page) { pages_.close_bytes(page.bytes); }  // at all its addresses
    void forget() { pages_.close_all(); }

private:
    void look_up(std::uint32_t address, Page& page) const;

    const CpuState& cpu_;
    MemoryMap memory_;
    PageTable pages_;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> forbidden_;  // base and size
};

}  // namespace sim
