// memory_map.h - what answers at a physical address: RAM of the host, or the bus.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace sim {

class MemoryMap {
public:
    struct Area {
        std::uint32_t base;
        std::uint64_t size;
        std::uint8_t* bytes;       // RAM; nullptr: the bus
        std::uint32_t bus_base;    // the bus's address of `base`
        unsigned access;           // arm_access
        bool data_by_bus = false;  // RAM, but loads and stores go by the bus

        bool contains(std::uint32_t address) const { return address - base < size; }
    };

    void add(const Area& area) { areas_.push_back(area); }
    // The areas that begin at `base`.
    void remove(std::uint32_t base);
    // nullptr: nothing is mapped there.  Costs 1 ns if it is the same area as last time.
    const Area* find(std::uint32_t address) const;
    // The host's bytes of RAM, if all are in one area; otherwise nullptr.
    std::uint8_t* ram(std::uint32_t address, std::size_t bytes) const;

private:
    std::vector<Area> areas_;
    mutable std::size_t last_ = 0;
};

}  // namespace sim
