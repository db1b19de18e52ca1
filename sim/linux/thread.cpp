#include "sim/linux/thread.h"

namespace sim {

void LinuxThread::save(const ArmCore& core) {
    for (unsigned i = 0; i < 16; ++i) r[i] = core.reg(i);
    cpsr = core.cpsr();
    fpscr = core.fpscr();
    own_tls = core.cp15(cp15::TPIDRURW);
    for (unsigned i = 0; i < 32; ++i) vfp[i] = core.vfp(i);
}

void LinuxThread::load(ArmCore& core) const {
    core.set_cpsr(cpsr);
    for (unsigned i = 0; i < 16; ++i) core.set_reg(i, r[i]);
    core.set_fpscr(fpscr);
    core.set_cp15(cp15::TPIDRURW, own_tls);
    for (unsigned i = 0; i < 32; ++i) core.set_vfp(i, vfp[i]);
    core.clear_exclusive();
}

}  // namespace sim
