#include "sim/cpu/dynarmic/modes.h"

#include <algorithm>

#include "sim/cpu/arm_core.h"

namespace sim {

BankedRegisters::Bank BankedRegisters::bank_of(std::uint32_t mode) {
    switch (mode & arm_cpsr::MODE) {
        case arm_mode::FIQ: return FIQ;
        case arm_mode::IRQ: return IRQ;
        case arm_mode::SVC: return SVC;
        case arm_mode::ABT: return ABT;
        case arm_mode::UND: return UND;
        default: return USER;
    }
}

void BankedRegisters::change(std::array<std::uint32_t, 16>& r, std::uint32_t from,
                             std::uint32_t to) {
    const Bank before = bank_of(from), after = bank_of(to);
    if (before == after) return;
    std::copy_n(&r[13], 2, high_[before].begin());
    std::copy_n(high_[after].begin(), 2, &r[13]);
    if (before != FIQ && after != FIQ) return;
    std::copy_n(&r[8], 5, (before == FIQ ? fiq_middle_ : user_middle_).begin());
    std::copy_n((after == FIQ ? fiq_middle_ : user_middle_).begin(), 5, &r[8]);
}

std::uint32_t& BankedRegisters::user(std::array<std::uint32_t, 16>& r, std::uint32_t mode,
                                     unsigned number) {
    const Bank bank = bank_of(mode);
    if (number >= 13 && number <= 14 && bank != USER) return high_[USER][number - 13];
    if (number >= 8 && number <= 12 && bank == FIQ) return user_middle_[number - 8];
    return r[number];
}

}  // namespace sim
