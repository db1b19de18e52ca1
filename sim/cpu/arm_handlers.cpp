#include "sim/cpu/arm_handlers.h"

#include <fmt/format.h>

namespace sim {

namespace {

// Branches to themselves: ARM's, Thumb's of 16 bits and of 32.
constexpr std::uint32_t ARM_SPIN = 0xEAFFFFFE, THUMB_SPIN = 0xE7FE, THUMB2_SPIN = 0xBFFEF7FF;

}  // namespace

bool ArmHandlers::in_handler() const {
    switch (core_.cpsr() & arm_cpsr::MODE) {
        case arm_mode::ABT:
        case arm_mode::UND:
        case arm_mode::IRQ:
        case arm_mode::FIQ: return true;
    }
    return false;
}

bool ArmHandlers::spins() const {
    std::uint32_t code = 0;
    if (!(core_.cpsr() & arm_cpsr::T))
        return core_.read_ram(core_.pc(), &code, 4) && code == ARM_SPIN;
    if (core_.read_ram(core_.pc(), &code, 2) && code == THUMB_SPIN) return true;
    return core_.read_ram(core_.pc(), &code, 4) && code == THUMB2_SPIN;
}

bool ArmHandlers::stands_still() const {
    constexpr std::uint32_t MASKED = arm_cpsr::I | arm_cpsr::F;
    return (core_.cpsr() & MASKED) == MASKED && spins();
}

std::string ArmHandlers::never_left(const std::string& where) const {
    return open_->text + "; never left its handler: " + where;
}

void ArmHandlers::leave() {
    open_.reset();
    abort_log_.handled();
}

bool ArmHandlers::happens_again(ArmException exception) {
    if (is_asynchronous(exception) || exception == ArmException::SVC) return false;
    const std::uint32_t mode = core_.cpsr() & arm_cpsr::MODE;
    const bool nested =
        mode == (exception == ArmException::UNDEFINED ? arm_mode::UND : arm_mode::ABT);
    if (!nested) return false;
    const bool again = nested_pc_ == core_.pc();
    nested_pc_ = core_.pc();
    return again;
}

void ArmHandlers::enter(ArmException exception, const std::string& text) {
    abort_log_.happened(static_cast<unsigned>(exception), core_.pc(), text);
    count_repetition();
    if (!open_) open_ = Open{exception, text, time_.now(), time_.now()};
}

void ArmHandlers::count_repetition() {
    decltype(repeated_state_) registers;
    for (unsigned i = 0; i < 16; ++i) registers[i] = core_.reg(i);
    registers[16] = core_.cpsr();
    repetitions_ = registers == repeated_state_ ? repetitions_ + 1 : 1;
    repeated_state_ = registers;
}

std::optional<std::string> ArmHandlers::failure(const std::string& where) {
    if (!in_handler()) {
        const bool back_at_it =
            repetitions_ >= MANY_REPETITIONS && core_.pc() == repeated_state_[15];
        if (back_at_it)
            return fmt::format("{}; its handler leads back to it, {} times", open_->text,
                               repetitions_);
        if (repetitions_ >= MANY_REPETITIONS) repetitions_ = 0;
        leave();
    } else if (!(core_.cpsr() & arm_cpsr::I) || !spins()) {
        open_->spins_from = time_.now();
    } else if (time_.now() - open_->spins_from >= spin_limit()) {
        return never_left(where);
    }
    return std::nullopt;
}

void ArmHandlers::conclude_failure(bool goes_on) {
    if (!goes_on) abort_log_.failed(open_->text);
    open_.reset();
    repetitions_ = 0;
}

std::optional<std::string> ArmHandlers::unfinished(const std::string& where) const {
    if (!open_ || !in_handler()) return std::nullopt;
    if (!spins() && time_.now() - open_->since <= handler_grace()) return std::nullopt;
    return never_left(where);
}

void ArmHandlers::end(bool failed) {
    if (failed) abort_log_.failed(open_ ? open_->text : "");
    abort_log_.end();
}

}  // namespace sim
