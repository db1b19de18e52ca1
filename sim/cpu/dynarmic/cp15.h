// cp15.h - the system control coprocessor of the Cortex-A9 (ARM DDI 0388I, chapter 4).
//
// Identification is that of the Cyclone V's r3p0.  Cache maintenance and barriers do nothing: the
// simulator has no caches and detects by itself that code is overwritten.  The performance monitor
// has its cycle counter, which counts instructions; PMCR.D has no effect.
//
// Address translation operations are in system_registers.h: they walk the tables.
//
// Not handled: event counters (read 0), lockdown, the second bank of registers for the Secure
// state.
#pragma once

#include <cstdint>
#include <map>
#include <optional>

#include "sim/cpu/arm_core.h"

namespace sim {

constexpr std::uint32_t SCTLR_M = 1;        // addresses are translated
constexpr std::uint32_t SCTLR_A = 1u << 1;  // nothing may be unaligned

class Cp15Registers {
public:
    Cp15Registers() { reset(); }
    void reset();

    // What a write changes besides the register.
    enum class Effect { NONE, TRANSLATION, FLOATING_POINT };

    // As MRC and MCR do.  Nothing: the instruction is undefined.  `instructions`: so far.
    std::optional<std::uint32_t> read(const Cp15& name, bool privileged,
                                      std::uint64_t instructions) const;
    std::optional<Effect> write(const Cp15& name, std::uint32_t value, bool privileged,
                                std::uint64_t instructions);

    // Without checks, for the simulator.
    std::uint32_t value(const Cp15& name) const;
    void set(const Cp15& name, std::uint32_t value) { at(name) = value; }

    // Registers that translated code reads and writes by itself.
    std::uint32_t tpidrurw = 0, tpidruro = 0, tpidrprw = 0;

private:
    static std::uint32_t key(const Cp15& name) {
        return name.crn << 12 | name.op1 << 8 | name.crm << 4 | name.op2;
    }
    std::uint32_t& at(const Cp15& name);
    bool is_users_counter(const Cp15& name) const;
    std::uint64_t cycles(std::uint64_t instructions) const;

    std::map<std::uint32_t, std::uint32_t> values_;
    std::uint64_t cycles_begin_ = 0;  // of the cycle counter: instructions at its zero
    std::optional<std::uint64_t> stopped_at_ = 0;
};

}  // namespace sim
