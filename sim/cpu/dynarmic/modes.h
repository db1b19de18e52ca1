// modes.h - the registers that ARMv7-A banks by processor mode (ARM DDI 0406C, B1.3.2).
//
//   mode            USR SYS   FIQ        IRQ SVC ABT UND
//   own registers   r8-r14    r8-r14     r13 r14 (r8-r12 are those of USR)
//                   -         SPSR       SPSR
#pragma once

#include <array>
#include <cstdint>

namespace sim {

class BankedRegisters {
public:
    // Saves the registers of mode `from` and loads those of mode `to`.  Numbers of modes are those
    // of the CPSR; one that does not exist counts as USR.
    void change(std::array<std::uint32_t, 16>& r, std::uint32_t from, std::uint32_t to);
    // r`number`, 8 to 14, of the user mode while the processor is in mode `mode`.
    std::uint32_t& user(std::array<std::uint32_t, 16>& r, std::uint32_t mode, unsigned number);
    // USR and SYS have none: returns a word that is never used.
    std::uint32_t& spsr(std::uint32_t mode) { return spsr_[bank_of(mode)]; }
    const std::uint32_t& spsr(std::uint32_t mode) const { return spsr_[bank_of(mode)]; }

private:
    enum Bank { USER, FIQ, IRQ, SVC, ABT, UND, BANKS };
    static Bank bank_of(std::uint32_t mode);

    std::array<std::array<std::uint32_t, 2>, BANKS> high_{};     // r13, r14
    std::array<std::uint32_t, 5> user_middle_{}, fiq_middle_{};  // r8 - r12
    std::array<std::uint32_t, BANKS> spsr_{};
};

}  // namespace sim
