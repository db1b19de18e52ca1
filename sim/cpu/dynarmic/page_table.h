// page_table.h - virtual pages of 4 KB: the host's bytes where translated code may access them
// directly, and a small cache of the attributes of the other pages.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "sim/cpu/arm_core.h"

namespace sim {

class PageTable {
public:
    static constexpr std::size_t PAGES = 1u << 20;
    using Direct = std::array<std::uint8_t*, PAGES>;

    // What a page is, for the present privilege.
    struct Page {
        std::uint32_t number = ~0u;          // virtual
        std::uint32_t physical = 0;          // its first address, on the bus or in RAM
        std::uint8_t* bytes = nullptr;       // of RAM; nullptr: the bus, or nothing
        const std::uint8_t* code = nullptr;  // of RAM, also where loads and stores take the bus
        unsigned access = 0;                 // arm_access
        bool no_code = false;                // by the translation tables
        bool normal = false;                 // Normal memory, by the translation tables
        std::uint8_t cache = 0;              // the same as ArmCore::OnBus has it
        std::uint32_t status = 0;            // fault status of an access that is not allowed

        bool may_execute() const { return code && (access & arm_access::EXECUTE); }
    };

    PageTable();
    Direct* direct() { return direct_.get(); }

    // Translated code may read and write the page without asking.
    void open(std::uint32_t page, std::uint8_t* bytes);
    void close_bytes(const std::uint8_t* bytes);  // every page that is opened onto them
    void close_all();                             // and empties the cache

    // The cache's slot for a page; it may hold another page.
    Page& slot(std::uint32_t page) { return cache_[page % cache_.size()]; }

private:
    struct Unmap {
        void operator()(Direct* direct) const;
    };
    std::unique_ptr<Direct, Unmap> direct_;
    std::vector<std::uint32_t> opened_;
    std::array<Page, 64> cache_;
};

}  // namespace sim
