// arm_failure.cpp - ArmCpu's detection of programs that never return from an abort, or that have
// ended
#include "sim/cpu/arm_cpu.h"

#include <algorithm>

#include <fmt/format.h>

namespace sim {

using sc_core::sc_time;

namespace {

// Branches to themselves: ARM's, Thumb's of 16 bits and of 32.
constexpr std::uint32_t ARM_SPIN = 0xEAFFFFFE, THUMB_SPIN = 0xE7FE, THUMB2_SPIN = 0xBFFEF7FF;

}  // namespace

// In the handler of an abort or undefined instruction, or in an interrupt of that handler.
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

std::string ArmCpu::failure() const { return open_->text + "; never left its handler: " + where(); }

void ArmCpu::left_handler() {
    open_.reset();
    abort_log_.handled();
}

void ArmCpu::conclude() {
    if (fault() || unfinished()) abort_log_.failed(open_ ? open_->text : "");
    abort_log_.end();
    final_ = position();
}

std::optional<std::string> ArmCpu::unfinished() const {
    if (!open_ || !in_handler()) return std::nullopt;
    if (!spins() && now() - open_->since <= handler_grace()) return std::nullopt;
    return failure();
}

// Counts the exceptions that happen at the same instruction with the same registers.
void ArmCpu::count_repetition() {
    decltype(repeated_state_) registers;
    for (unsigned i = 0; i < 16; ++i) registers[i] = core_.reg(i);
    registers[16] = core_.cpsr();
    repetitions_ = registers == repeated_state_ ? repetitions_ + 1 : 1;
    repeated_state_ = registers;
}

// Called after each quantum.
void ArmCpu::check_failure() {
    if (!open_) return;
    const auto dies = [this](const std::string& text) {
        const bool goes_on = inspector_ && inspector_->on_failure(core_, open_->exception);
        if (!goes_on) abort_log_.failed(open_->text);
        open_.reset();
        repetitions_ = 0;
        if (!goes_on) fail(text);
    };
    if (!in_handler()) {
        const bool back_at_it =
            repetitions_ >= MANY_REPETITIONS && core_.pc() == repeated_state_[15];
        if (back_at_it)
            return dies(fmt::format("{}; its handler leads back to it, {} times", open_->text,
                                    repetitions_));
        if (repetitions_ >= MANY_REPETITIONS) repetitions_ = 0;
        left_handler();
    } else if (!(core_.cpsr() & arm_cpsr::I) || !spins()) {
        open_->spins_from = now();
    } else if (now() - open_->spins_from >= spin_limit()) {
        dies(failure());
    }
}

// Called after each quantum.
void ArmCpu::check_end() {
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
