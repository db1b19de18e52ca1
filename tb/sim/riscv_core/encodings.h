// encodings.h - RISC-V instructions as words, for programs of a few of them
#pragma once

#include <cstdint>
#include <initializer_list>
#include <vector>

namespace tb::riscv {

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
// Any value into rd, in two instructions.
inline std::vector<std::uint32_t> li(unsigned rd, std::uint32_t value) {
    const std::uint32_t upper = (value + 0x800) & 0xFFFFF000;
    return {upper | rd << 7 | 0x37, addi(rd, rd, static_cast<std::int32_t>(value - upper))};
}

inline std::vector<std::uint32_t> joined(std::initializer_list<std::vector<std::uint32_t>> parts) {
    std::vector<std::uint32_t> all;
    for (const auto& part : parts) all.insert(all.end(), part.begin(), part.end());
    return all;
}

}  // namespace tb::riscv
