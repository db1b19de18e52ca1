// bench.h - test fixture: a RiscvCore with 64 KB of RAM at 0 and one device at DEVICE
#pragma once

#include <cstdint>
#include <cstring>
#include <functional>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "sim/cpu/riscv/core.h"
#include "tb/sim/riscv_core/encodings.h"

namespace tb::riscv {

constexpr std::uint32_t DEVICE = 0xFF200000, NOBODY = 0x80000000, RAM = 0x10000;

class RiscvBench : public testing::Test, protected sim::RiscvBus {
protected:
    void load(std::uint32_t address, const std::vector<std::uint32_t>& words) {
        core.write_ram(address, words.data(), words.size() * 4);
    }
    // Loads to address 0, starts there.
    void start(const std::vector<std::uint32_t>& words) {
        load(0, words);
        core.reset(0);
    }
    std::uint32_t csr(std::uint32_t number) { return core.csr(number).value(); }

    std::vector<std::uint32_t> accesses;  // their addresses
    std::function<void()> on_access = [] {};
    std::uint32_t device = 0;  // what it holds

private:
    bool read(std::uint32_t address, unsigned, std::uint32_t& value) override {
        value = device;
        return access(address);
    }
    bool write(std::uint32_t address, unsigned, std::uint32_t value) override {
        device = value;
        return access(address);
    }
    bool access(std::uint32_t address) {
        if (address != DEVICE) return false;
        accesses.push_back(address);
        on_access();
        return true;
    }
    std::uint64_t cycles() override { return core.clocks(); }

    std::vector<std::uint8_t> ram_ = std::vector<std::uint8_t>(RAM);

protected:
    sim::RiscvCore core{*this};

    RiscvBench() { core.map_ram(0, RAM, ram_.data()); }
};

}  // namespace tb::riscv
