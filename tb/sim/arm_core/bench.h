// bench.h - an ArmCore with RAM, and a bus that records accesses.
//
//   0x00000000  1 MB of RAM, Normal memory
//   0x00100000  4 KB of the bus that answer
//   0x00101000  4 KB of the bus without a target
//   0x00102000  nothing
#pragma once

#include <cstdint>
#include <cstring>
#include <functional>
#include <vector>

#include "sim/cpu/arm_core.h"

namespace tb::core {

constexpr std::uint32_t RAM = 0x100000, BUS = 0x100000, REFUSED = 0x101000, NOTHING = 0x102000;

class Bench : public sim::ArmBus {
public:
    struct Access {
        std::uint64_t count;  // instructions before, and this one
        std::uint32_t pc, address;
        unsigned bytes;
        bool write;
        std::uint32_t value;

        bool operator==(const Access& o) const {
            return count == o.count && pc == o.pc && address == o.address && bytes == o.bytes &&
                   write == o.write && value == o.value;
        }
    };

    std::vector<std::uint8_t> ram = std::vector<std::uint8_t>(RAM + 0x1000);
    std::vector<Access> accesses;
    std::function<void()> on_access = [] {}, on_unmasked = [] {};
    bool interrupt_waits = false;
    sim::ArmCore core{*this};

    Bench() {
        core.reset(0, RAM / 2);
        core.set_floating_point(true);
        core.map_ram(0, RAM, memory(), sim::arm_access::ALL | sim::arm_access::NORMAL);
        core.map_bus(BUS, 0x2000, BUS);
    }

    // Aligned to 4 KB.
    std::uint8_t* memory() {
        return ram.data() +
               (0x1000 - reinterpret_cast<std::uintptr_t>(ram.data()) % 0x1000) % 0x1000;
    }
    std::uint32_t word(std::uint32_t address) {
        std::uint32_t value;
        std::memcpy(&value, memory() + address, 4);
        return value;
    }
    // Instructions or data, as a loader from outside puts them.
    void put(std::uint32_t address, const std::vector<std::uint32_t>& words) {
        core.write_ram(address, words.data(), 4 * words.size());
    }
    void put_halves(std::uint32_t address, const std::vector<std::uint16_t>& halves) {
        core.write_ram(address, halves.data(), 2 * halves.size());
    }

    bool read(std::uint32_t address, unsigned bytes, std::uint32_t& value) override {
        if (address >= REFUSED) return false;
        value = (static_cast<std::uint32_t>(accesses.size()) + 1) * 0x9E3779B1 >> (32 - 8 * bytes);
        note(address, bytes, false, value);
        return true;
    }
    bool write(std::uint32_t address, unsigned bytes, std::uint32_t value) override {
        if (address >= REFUSED) return false;
        note(address, bytes, true, bytes == 4 ? value : value & ((1u << 8 * bytes) - 1));
        return true;
    }
    bool passes_wfi() override { return interrupt_waits; }
    void unmasked() override { on_unmasked(); }

private:
    void note(std::uint32_t address, unsigned bytes, bool is_write, std::uint32_t value) {
        accesses.push_back(
            {core.instructions(), core.instruction(), address, bytes, is_write, value});
        on_access();
    }
};

}  // namespace tb::core
