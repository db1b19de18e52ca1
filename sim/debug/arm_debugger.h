// arm_debugger.h - GDB at the ARM: its registers, its exceptions, the threads of a Linux program.
//
// Memory is by physical address.  Stops by itself: a BKPT instruction (SIGTRAP), an exception that
// the program has no vector for (SIGILL, SIGSEGV, SIGSYS).  A Linux program: before a signal ends
// it, before an oops of a module does (SIGSEGV), and before it ends because all threads wait for
// each other (SIGABRT).
//
// Linux: GDB sees the threads of all processes and modules as those of one program.  `thread 3`
// chooses one: registers are its own, memory is that of its process.  When one thread stops, all
// stand, and they go on together, as the scheduler has them.  A step ends when its thread has
// executed one instruction, however many others have executed meanwhile.  Ctrl-C stops a program
// whose threads all wait, too; GDB is shown the first thread then.
// A point is an address, in whatever process: also in the child of a fork(), and in another program
// that has something else there.
// Kernel modules are at fixed addresses, so a breakpoint in one may be set before it is loaded.
// `monitor modules`: GDB's commands that load their names.
//
// Costs nothing until a point is set.  A breakpoint costs time when it is reached.  A watchpoint is
// checked at every load and store, about 10 ns each.
//
// Not handled: translation tables that are not flat, banked registers of other modes, CP15,
// thread-local variables by their names, the files of other programs that processes become, one
// thread that goes on alone (`set scheduler-locking on`).
#pragma once

#include "sim/cpu/arm_cpu.h"
#include "sim/debug/arm_registers.h"
#include "sim/debug/debugger.h"

namespace sim {

class ArmDebugger final : public Debugger,
                          private ArmInspector,
                          private ArmProbe,
                          private ArmWatch {
public:
    // Attaches itself.
    ArmDebugger(ArmCpu& cpu, GdbConnection& connection, std::function<bool()> given_up);
    ~ArmDebugger() override;

private:
    void on_start(ArmCore&) override { begin(); }
    std::uint64_t on_quantum(ArmCore&, std::uint64_t limit) override {
        return quantum_begins() ? 1 : limit;
    }
    bool on_exception(ArmCore& core, ArmException exception, const ArmFault& fault) override;
    bool on_failure(ArmCore& core, ArmException exception) override;
    void on_end(ArmCore& core, unsigned signal) override;
    void on_idle(ArmCore&) override { idles(); }
    bool holds_interrupts() override { return keeps_interrupts_out(); }
    bool before(std::uint32_t) override { return reached(); }
    bool touched(std::uint32_t address, unsigned bytes, bool write) override {
        return touches_point(address, bytes, write);
    }

    const GdbRegisters& registers() const override { return arm_registers(); }
    std::uint64_t reg(unsigned number) override;
    bool set_reg(unsigned number, std::uint64_t value) override;
    std::uint32_t displacement() override;
    std::vector<GdbThread> threads() override;

    std::uint32_t pc() const override { return core_.pc(); }
    std::uint64_t instructions() const override { return core_.instructions(); }
    bool read_ram(std::uint32_t address, void* data, std::size_t bytes) override {
        return core_.read_ram(address, data, bytes);
    }
    bool write_ram(std::uint32_t address, const void* data, std::size_t bytes) override {
        return core_.write_ram(address, data, bytes);
    }
    void observe(const std::vector<std::uint32_t>& breaks, bool accesses) override;
    std::uint32_t running() const override;
    void show_memory_of(std::uint32_t thread) override;
    std::string own_monitor(std::string_view command) override;
    std::string own_monitor_help() const override;

    ArmRegisters* saved();

    ArmCpu& cpu_;
    ArmCore& core_;
};

}  // namespace sim
