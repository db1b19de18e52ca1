// bench.h - test fixture: a RiscvCore with 64 KB of RAM at 0 and one device at DEVICE
#pragma once

#include <cstdint>
#include <cstring>
#include <functional>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "sim/cpu/riscv/core.h"

namespace tb::riscv {

constexpr std::uint32_t DEVICE = 0xFF200000, NOBODY = 0x80000000, RAM = 0x10000;

// Instructions as words.
constexpr std::uint32_t NOP = 0x13, ECALL = 0x73, EBREAK = 0x00100073, MRET = 0x30200073,
                        WFI = 0x10500073, FENCE_I = 0x0000100F;
constexpr std::uint32_t addi(unsigned rd, unsigned rs1, std::int32_t imm) {
    return static_cast<std::uint32_t>(imm) << 20 | rs1 << 15 | rd << 7 | 0x13;
}
constexpr std::uint32_t lw(unsigned rd, unsigned rs1, std::int32_t imm) {
    return static_cast<std::uint32_t>(imm) << 20 | rs1 << 15 | 2 << 12 | rd << 7 | 0x03;
}
constexpr std::uint32_t sw(unsigned rs2, unsigned rs1, std::uint32_t imm) {
    return (imm >> 5 & 0x7F) << 25 | rs2 << 20 | rs1 << 15 | 2 << 12 | (imm & 31) << 7 | 0x23;
}
constexpr std::uint32_t jalr(unsigned rd, unsigned rs1) { return rs1 << 15 | rd << 7 | 0x67; }
constexpr std::uint32_t csrrw(unsigned rd, std::uint32_t csr, unsigned rs1) {
    return csr << 20 | rs1 << 15 | 1 << 12 | rd << 7 | 0x73;
}
constexpr std::uint32_t csrrs(unsigned rd, std::uint32_t csr, unsigned rs1) {
    return csrrw(rd, csr, rs1) + (1 << 12);
}
constexpr std::uint32_t jump(std::int32_t bytes) {  // at most 2 KB, forward or back
    const auto b = static_cast<std::uint32_t>(bytes);
    return (b >> 20 & 1) << 31 | (b >> 1 & 0x3FF) << 21 | (b >> 11 & 1) << 20 |
           (b >> 12 & 0xFF) << 12 | 0x6F;
}

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
