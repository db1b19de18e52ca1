// nios_v_profile.h - a profile of a program for Nios V, in runs of its instructions
//
// A run has no jump in it and is of one function.  Looks at each instruction, so that a program
// takes up to twice as long.
#pragma once

#include "sim/cpu/riscv/core.h"
#include "sim/profile/profile.h"

namespace sim {

class NiosVProfile final : public RiscvTally {
public:
    // Attaches itself; both must outlive it.
    NiosVProfile(RiscvCore& core, Profile& profile);
    ~NiosVProfile() { core_.attach(static_cast<RiscvTally*>(nullptr)); }
    NiosVProfile(const NiosVProfile&) = delete;
    NiosVProfile& operator=(const NiosVProfile&) = delete;

    // Adds what has run since the last jump.
    void finish();

private:
    void executes(std::uint32_t pc) override;

    RiscvCore& core_;
    Profile& profile_;
    Profile::Run run_{0, 0, 0, 0};  // what runs; its end so far
    std::uint64_t first_ = 0;       // instructions before it
    std::uint64_t traps_ = 0;       // before it
};

}  // namespace sim
