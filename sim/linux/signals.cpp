#include "sim/linux/signals.h"

#include <csignal>
#include <cstddef>
#include <cstring>

#include "sim/linux/arm_abi.h"
#include "sim/linux/start.h"

namespace sim {

namespace {

constexpr std::uint32_t ON_SIGNAL_FRAME = 8;  // alignment

struct SigContext {
    std::uint32_t trap, error, old_mask, r[16], cpsr, fault_address;
};
struct UContext {
    std::uint32_t flags, link, stack[3];
    SigContext context;
    std::uint32_t mask[2], unused[30];
    std::uint32_t registers[128];
};
struct Frame {
    std::uint32_t info[32];
    UContext context;
    std::uint32_t code[4];
};
static_assert(sizeof(SigContext) == 84 && offsetof(UContext, registers) == 232);

}  // namespace

bool LinuxSignals::ignored_by_default(unsigned number) {
    return number == SIGCHLD || number == SIGCONT || number == SIGURG || number == SIGWINCH;
}

const char* LinuxSignals::name(unsigned number) {
    static const char* const NAMES[] = {
        "SIGHUP",  "SIGINT",    "SIGQUIT", "SIGILL",   "SIGTRAP", "SIGABRT", "SIGBUS",  "SIGFPE",
        "SIGKILL", "SIGUSR1",   "SIGSEGV", "SIGUSR2",  "SIGPIPE", "SIGALRM", "SIGTERM", "SIGSTKFLT",
        "SIGCHLD", "SIGCONT",   "SIGSTOP", "SIGTSTP",  "SIGTTIN", "SIGTTOU", "SIGURG",  "SIGXCPU",
        "SIGXFSZ", "SIGVTALRM", "SIGPROF", "SIGWINCH", "SIGIO",   "SIGPWR",  "SIGSYS"};
    return number >= 1 && number <= 31 ? NAMES[number - 1] : "a real-time signal";
}

std::optional<unsigned> LinuxSignals::next() const {
    const std::uint64_t ready = pending & ~blocked;
    for (unsigned number = 1; number <= COUNT; ++number)
        if (ready & bit(number)) return number;
    return std::nullopt;
}

bool LinuxSignals::enter(ArmCore& core, AddressSpace& memory, unsigned number,
                         std::uint32_t address) {
    Action& action = actions[number];
    Frame frame{};
    frame.info[0] = number;
    frame.info[3] = address;
    SigContext& context = frame.context.context;
    for (unsigned i = 0; i < 16; ++i) context.r[i] = core.reg(i);
    context.cpsr = core.cpsr();
    context.fault_address = address;
    std::memcpy(frame.context.mask, &blocked, sizeof blocked);

    const std::uint32_t sp = core.reg(13);
    const bool on_stack = sp - stack < stack_size;
    const bool other = (action.flags & arm_signal::ON_STACK) && stack_size > 0 && !on_stack;
    const std::uint32_t at =
        ((other ? stack + stack_size : sp) - static_cast<std::uint32_t>(sizeof frame)) &
        ~(ON_SIGNAL_FRAME - 1);
    const bool rt = action.flags & arm_signal::TAKES_INFO;
    const auto ucontext = at + static_cast<std::uint32_t>(offsetof(Frame, context));
    if (!memory.write(at, &frame, sizeof frame)) return false;

    core.set_reg(13, rt ? at : ucontext);
    core.set_reg(0, number);
    core.set_reg(1, at);
    core.set_reg(2, ucontext);
    core.set_reg(14, action.flags & arm_signal::HAS_RESTORER ? action.restorer
                     : rt                                    ? RT_SIGRETURN_CODE
                                                             : SIGRETURN_CODE);
    const std::uint32_t thumb = action.handler & 1 ? arm_cpsr::T : 0;
    core.set_cpsr((core.cpsr() & ~(arm_cpsr::T | arm_cpsr::IT)) | thumb);
    core.set_reg(15, action.handler & ~1u);
    blocked |= action.mask | (action.flags & arm_signal::NO_DEFER ? 0 : bit(number));
    if (action.flags & arm_signal::RESETS) action.handler = 0;
    return true;
}

bool LinuxSignals::leave(ArmCore& core, const AddressSpace& memory, bool rt) {
    UContext frame;
    const std::uint32_t begin = rt ? static_cast<std::uint32_t>(offsetof(Frame, context)) : 0;
    if (!memory.read(core.reg(13) + begin, &frame, sizeof frame)) return false;
    constexpr std::uint32_t PROGRAMS_OWN = 0xF80F0000 | arm_cpsr::T | arm_cpsr::IT;
    core.set_cpsr((core.cpsr() & ~PROGRAMS_OWN) | (frame.context.cpsr & PROGRAMS_OWN));
    for (unsigned i = 0; i < 16; ++i) core.set_reg(i, frame.context.r[i]);
    std::memcpy(&blocked, frame.mask, sizeof blocked);
    return true;
}

}  // namespace sim
