// arm_death.cpp - ArmCpu's programs that never come back: from an abort, or from their end
#include "sim/hps/arm_cpu.h"

#include <algorithm>

namespace sim {

using sc_core::sc_time;

namespace {

// Branches to themselves: ARM's, Thumb's of 16 bits and of 32.
constexpr std::uint32_t ARM_SPIN = 0xEAFFFFFE, THUMB_SPIN = 0xE7FE, THUMB2_SPIN = 0xBFFEF7FF;

}  // namespace

// Of an abort or undefined instruction, or in an interrupt of it.
bool ArmCpu::in_handler() const {
    switch (core_.cpsr() & arm_cpsr::MODE) {
        case arm_mode::ABT:
        case arm_mode::UND:
        case arm_mode::IRQ:
        case arm_mode::FIQ: return true;
    }
    return false;
}

bool ArmCpu::spins() const {
    std::uint32_t code = 0;
    if (!(core_.cpsr() & arm_cpsr::T))
        return core_.read_ram(core_.pc(), &code, 4) && code == ARM_SPIN;
    if (core_.read_ram(core_.pc(), &code, 2) && code == THUMB_SPIN) return true;
    return core_.read_ram(core_.pc(), &code, 4) && code == THUMB2_SPIN;
}

bool ArmCpu::stands_still() const {
    constexpr std::uint32_t MASKED = arm_cpsr::I | arm_cpsr::F;
    return (core_.cpsr() & MASKED) == MASKED && spins();
}

std::string ArmCpu::death() const { return open_->text + "; never left its handler: " + where(); }

std::optional<std::string> ArmCpu::unfinished() const {
    if (!open_ || !in_handler()) return std::nullopt;
    if (!spins() && now() - open_->since <= moment()) return std::nullopt;
    return death();
}

// Called behind each quantum.
void ArmCpu::look_for_death() {
    if (!open_) return;
    if (!in_handler()) {
        open_.reset();
    } else if (!stands_still()) {
        open_->spins_from = now();
    } else if (now() - open_->spins_from >= spin_limit()) {
        const std::string text = death();
        const bool goes_on = inspector_ && inspector_->on_failure(core_, open_->exception);
        open_.reset();
        if (!goes_on) fail(text);
    }
}

// Called behind each quantum.
void ArmCpu::look_for_end() {
    if (!ended_ && (inspector_ || open_ || !stands_still()))
        over_since_.reset();
    else if (!over_since_)
        over_since_ = now();
}

sc_time ArmCpu::ended_for() const {
    return over_since_ ? sc_core::sc_time_stamp() - std::min(*over_since_, sc_core::sc_time_stamp())
                       : sc_core::SC_ZERO_TIME;
}

}  // namespace sim
