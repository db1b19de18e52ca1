#include "sim/linux/signals.h"

#include <algorithm>
#include <csignal>
#include <cstddef>
#include <cstring>
#include <iterator>

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
// Of registers[]: the floating-point unit's, and the end of such records.
struct VfpFrame {
    std::uint32_t magic, size;
    std::uint64_t d[32];
    std::uint32_t fpscr, pad, fpexc, fpinst, fpinst2, pad2, end[2];
};
constexpr std::uint32_t VFP_MAGIC = 0x56465001, FPEXC_ENABLED = 0x40000000;
struct Frame {
    std::uint32_t info[32];
    UContext context;
    std::uint32_t code[4];
};
static_assert(sizeof(SigContext) == 84 && offsetof(UContext, registers) == 232);
static_assert(offsetof(VfpFrame, end) == 288 && sizeof(VfpFrame) <= sizeof(UContext::registers));

}  // namespace

bool LinuxSignals::ignored_by_default(unsigned number) {
    return number == SIGCHLD || number == SIGCONT || number == SIGURG || number == SIGWINCH;
}

bool LinuxSignals::stops_by_default(unsigned number) {
    return number == SIGSTOP || number == SIGTSTP || number == SIGTTIN || number == SIGTTOU;
}

const char* LinuxSignals::name(unsigned number) {
    static const char* const NAMES[] = {
        "SIGHUP",  "SIGINT",    "SIGQUIT", "SIGILL",   "SIGTRAP", "SIGABRT", "SIGBUS",  "SIGFPE",
        "SIGKILL", "SIGUSR1",   "SIGSEGV", "SIGUSR2",  "SIGPIPE", "SIGALRM", "SIGTERM", "SIGSTKFLT",
        "SIGCHLD", "SIGCONT",   "SIGSTOP", "SIGTSTP",  "SIGTTIN", "SIGTTOU", "SIGURG",  "SIGXCPU",
        "SIGXFSZ", "SIGVTALRM", "SIGPROF", "SIGWINCH", "SIGIO",   "SIGPWR",  "SIGSYS"};
    return number >= 1 && number <= 31 ? NAMES[number - 1] : "a real-time signal";
}

// ---- Pending ------------------------------------------------------------------------------------

bool PendingSignals::add(const LinuxSignal& signal) {
    constexpr std::size_t MOST = 1024;
    const bool of_timer = signal.timer.number >= 0;
    if (!of_timer && signal.number < LinuxSignals::FIRST_REAL_TIME &&
        (set() & LinuxSignals::bit(signal.number)))
        return true;
    if (!of_timer && all_.size() >= MOST) return false;
    all_.push_back(signal);
    ++added_;
    return true;
}

std::uint64_t PendingSignals::set() const {
    std::uint64_t set = 0;
    for (const LinuxSignal& signal : all_) set |= LinuxSignals::bit(signal.number);
    return set;
}

std::optional<LinuxSignal> PendingSignals::dequeue(std::uint64_t blocked) {
    auto first = all_.end();
    for (auto it = all_.begin(); it != all_.end(); ++it)
        if (!(blocked & LinuxSignals::bit(it->number)) &&
            (first == all_.end() || it->number < first->number))
            first = it;
    if (first == all_.end()) return std::nullopt;
    const LinuxSignal signal = *first;
    all_.erase(first);
    return signal;
}

void PendingSignals::remove(std::uint64_t set) {
    for (auto it = all_.begin(); it != all_.end();)
        it = set & LinuxSignals::bit(it->number) ? all_.erase(it) : std::next(it);
}

LinuxSignal* PendingSignals::of_timer(int number) {
    for (LinuxSignal& signal : all_)
        if (signal.timer.number == number) return &signal;
    return nullptr;
}

void PendingSignals::remove_timers() {
    all_.erase(std::remove_if(all_.begin(), all_.end(),
                              [](const LinuxSignal& signal) { return signal.timer.number >= 0; }),
               all_.end());
}

// ---- Handlers -----------------------------------------------------------------------------------

bool ThreadSignals::enter(ArmCore& core, AddressSpace& memory, LinuxSignals::Action& action,
                          const LinuxSignal& signal) {
    Frame frame{};
    frame.info[0] = signal.number;
    frame.info[2] = static_cast<std::uint32_t>(signal.code);
    std::copy(signal.fields.begin(), signal.fields.end(), frame.info + 3);
    SigContext& context = frame.context.context;
    for (unsigned i = 0; i < 16; ++i) context.r[i] = core.reg(i);
    context.cpsr = core.cpsr();
    context.fault_address = signal.fields[0];
    const std::uint64_t mask = waits_with.value_or(blocked);
    waits_with.reset();
    std::memcpy(frame.context.mask, &mask, sizeof mask);
    VfpFrame vfp{VFP_MAGIC, offsetof(VfpFrame, end), {}, core.fpscr(), 0, FPEXC_ENABLED, 0, 0, 0,
                 {}};
    for (unsigned i = 0; i < 32; ++i) vfp.d[i] = core.vfp(i);
    std::memcpy(frame.context.registers, &vfp, sizeof vfp);

    const std::uint32_t sp = core.reg(13);
    const bool on_stack = sp - stack < stack_size;
    const bool other = (action.flags & arm_signal::ON_STACK) && stack_size > 0 && !on_stack;
    const std::uint32_t at =
        ((other ? stack + stack_size : sp) - static_cast<std::uint32_t>(sizeof frame)) &
        ~(ON_SIGNAL_FRAME - 1);
    const bool rt = action.flags & arm_signal::TAKES_INFO;
    const auto ucontext = at + static_cast<std::uint32_t>(offsetof(Frame, context));
    if (!memory.write(at, &frame, sizeof frame)) return false;

    core.clear_exclusive();
    core.set_reg(13, rt ? at : ucontext);
    core.set_reg(0, signal.number);
    core.set_reg(1, at);
    core.set_reg(2, ucontext);
    core.set_reg(14, action.flags & arm_signal::HAS_RESTORER ? action.restorer
                     : rt                                    ? RT_SIGRETURN_CODE
                                                             : SIGRETURN_CODE);
    const std::uint32_t thumb = action.handler & 1 ? arm_cpsr::T : 0;
    core.set_cpsr((core.cpsr() & ~(arm_cpsr::T | arm_cpsr::IT)) | thumb);
    core.set_reg(15, action.handler & ~1u);
    blocked |=
        action.mask | (action.flags & arm_signal::NO_DEFER ? 0 : LinuxSignals::bit(signal.number));
    if (action.flags & arm_signal::RESETS) action.handler = 0;
    return true;
}

bool ThreadSignals::leave(ArmCore& core, const AddressSpace& memory, bool rt) {
    UContext frame;
    const std::uint32_t begin = rt ? static_cast<std::uint32_t>(offsetof(Frame, context)) : 0;
    if (!memory.read(core.reg(13) + begin, &frame, sizeof frame)) return false;
    VfpFrame vfp;
    std::memcpy(&vfp, frame.registers, sizeof vfp);
    if (vfp.magic != VFP_MAGIC || vfp.size != offsetof(VfpFrame, end)) return false;
    for (unsigned i = 0; i < 32; ++i) core.set_vfp(i, vfp.d[i]);
    core.set_fpscr(vfp.fpscr);
    core.clear_exclusive();
    constexpr std::uint32_t PROGRAMS_OWN = 0xF80F0000 | arm_cpsr::T | arm_cpsr::IT;
    core.set_cpsr((core.cpsr() & ~PROGRAMS_OWN) | (frame.context.cpsr & PROGRAMS_OWN));
    for (unsigned i = 0; i < 16; ++i) core.set_reg(i, frame.context.r[i]);
    std::memcpy(&blocked, frame.mask, sizeof blocked);
    blocked &= ~(LinuxSignals::bit(SIGKILL) | LinuxSignals::bit(SIGSTOP));
    return true;
}

}  // namespace sim
