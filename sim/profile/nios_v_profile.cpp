#include "sim/profile/nios_v_profile.h"

namespace sim {

NiosVProfile::NiosVProfile(RiscvCore& core, Profile& profile) : core_{core}, profile_{profile} {
    core_.attach(this);
}

void NiosVProfile::finish() {
    run_.instructions = core_.instructions() - first_;
    if (run_.instructions > 0) profile_.ran(run_);
    first_ = core_.instructions();
}

// A trap is no call, even if it comes between a call and the function's first instruction.
void NiosVProfile::executes(std::uint32_t pc) {
    constexpr unsigned RA = 1;
    constexpr std::uint32_t NO_ADDRESS = 2;
    const bool trapped = core_.traps() != traps_;
    if (pc == run_.end && !trapped && profile_.is_here(pc)) {
        run_.end += 4;
        return;
    }
    finish();
    run_ = {pc, 0, trapped ? NO_ADDRESS : core_.reg(RA), pc + 4};
    traps_ = core_.traps();
}

}  // namespace sim
