#include "sim/debug/arm_debugger.h"

#include <csignal>
#include <cstring>

#include <fmt/format.h>

namespace sim {

namespace {

unsigned signal_of(ArmException exception) {
    switch (exception) {
        case ArmException::UNDEFINED: return gdb_signal::ILL;
        case ArmException::SVC: return gdb_signal::SYS;
        default: return gdb_signal::SEGV;
    }
}

unsigned signal_of_linux(unsigned signal) {
    switch (signal) {
        case SIGBUS: return gdb_signal::BUS;
        case SIGUSR1: return gdb_signal::USR1;
        case SIGUSR2: return gdb_signal::USR2;
        case SIGSYS: return gdb_signal::SYS;
        default: return signal <= SIGTERM ? signal : gdb_signal::UNKNOWN;
    }
}

bool is_breakpoint_instruction(const ArmCore& core) {
    std::uint32_t word = 0;
    const bool thumb = core.cpsr() & arm_cpsr::T;
    if (!core.read_ram(core.pc(), &word, thumb ? 2 : 4)) return false;
    return thumb ? (word & 0xff00) == 0xbe00 : (word & 0x0ff000f0) == 0x01200070;
}

// A word of a GDB command.
std::string quoted(const std::string& file) {
    std::string word;
    for (const char c : file) word += (std::strchr(" \t'\"\\", c) ? "\\" : "") + std::string{c};
    return word;
}

std::string commands_for(const std::vector<ArmModule>& modules) {
    std::string text;
    for (const ArmModule& module : modules)
        text += module.file.empty()
                    ? fmt::format("# {}: the program has it in memory, from no file\n", module.name)
                    : fmt::format("add-symbol-file {}\n", quoted(module.file.string()));
    return text.empty() ? "# no kernel module is loaded\n" : text;
}

}  // namespace

ArmDebugger::ArmDebugger(ArmCpu& cpu, GdbConnection& connection, std::function<bool()> given_up)
    : Debugger{cpu, connection, std::move(given_up)}, cpu_{cpu}, core_{cpu.core()} {
    cpu_.attach(static_cast<ArmInspector*>(this));
}

ArmDebugger::~ArmDebugger() { cpu_.attach(static_cast<ArmInspector*>(nullptr)); }

// ---- When to stop -------------------------------------------------------------------------------

bool ArmDebugger::on_exception(ArmCore& core, ArmException exception, const ArmFault&) {
    return exception == ArmException::PREFETCH_ABORT && is_breakpoint_instruction(core) &&
           stops_by(gdb_signal::TRAP);
}

bool ArmDebugger::on_failure(ArmCore&, ArmException exception) {
    return stops_by(signal_of(exception));
}

void ArmDebugger::on_end(ArmCore&, unsigned signal) { stops_by(signal_of_linux(signal)); }

// The core is only observed while there are points.
void ArmDebugger::observe(const std::vector<std::uint32_t>& breaks, bool accesses) {
    core_.attach(breaks.empty() ? nullptr : static_cast<ArmProbe*>(this), breaks);
    core_.watch(accesses ? this : nullptr);
}

// ---- Threads ------------------------------------------------------------------------------------

std::uint32_t ArmDebugger::running() const {
    const ArmKernel* const kernel = cpu_.kernel();
    return kernel ? kernel->running_thread() : 1;
}

std::vector<GdbThread> ArmDebugger::threads() {
    std::vector<GdbThread> list;
    if (const ArmKernel* const kernel = cpu_.kernel())
        for (const ArmThread& thread : kernel->thread_list())
            list.push_back({thread.number, thread.name, thread.state});
    if (list.empty()) list.push_back({1, "", ""});
    return list;
}

void ArmDebugger::show_memory_of(std::uint32_t thread) {
    if (ArmKernel* const kernel = cpu_.kernel()) kernel->show_memory_of(thread);
}

// The chosen thread's registers, unless the core has them.
ArmRegisters* ArmDebugger::saved() {
    ArmKernel* const kernel = cpu_.kernel();
    return kernel ? kernel->saved_registers(chosen()) : nullptr;
}

// ---- What the debugger sees and changes ---------------------------------------------------------

std::uint64_t ArmDebugger::reg(unsigned number) {
    using namespace arm_register;
    if (const ArmRegisters* const registers = saved()) {
        if (number == CPSR) return registers->cpsr;
        if (number == FPSCR) return registers->fpscr;
        return number < CPSR ? registers->r[number] : registers->vfp[number - D0];
    }
    if (number == CPSR) return core_.cpsr();
    if (number == FPSCR) return core_.fpscr();
    return number < CPSR ? core_.reg(number) : core_.vfp(number - D0);
}

bool ArmDebugger::set_reg(unsigned number, std::uint64_t value) {
    using namespace arm_register;
    const auto word = static_cast<std::uint32_t>(value);
    if (ArmRegisters* const registers = saved()) {
        if (number == CPSR)
            registers->cpsr = word;
        else if (number == FPSCR)
            registers->fpscr = word;
        else if (number < CPSR)
            registers->r[number] = word;
        else
            registers->vfp[number - D0] = value;
    } else if (number == CPSR) {
        core_.set_cpsr(word);
    } else if (number == FPSCR) {
        core_.set_fpscr(word);
    } else if (number < CPSR) {
        core_.set_reg(number, word);
    } else {
        core_.set_vfp(number - D0, value);
    }
    return true;
}

std::uint32_t ArmDebugger::displacement() {
    return cpu_.program().elf.movable ? POSITION_INDEPENDENT_BASE : 0;
}

std::string ArmDebugger::own_monitor(std::string_view command) {
    if (command != "modules") return "";
    const ArmKernel* const kernel = cpu_.kernel();
    return commands_for(kernel ? kernel->module_list() : std::vector<ArmModule>{});
}

std::string ArmDebugger::own_monitor_help() const {
    return "monitor modules: GDB's commands for the names of the kernel modules\n";
}

}  // namespace sim
