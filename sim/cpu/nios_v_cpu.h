// nios_v_cpu.h - a Nios V/g processor running the board's own ELF, as a TLM initiator in quanta
//
// 100 MHz, RV32IMAF (riscv/core.h).  A clock is 10 ns times `cpi`; an instruction takes the clocks
// of its class, as if all memory were in the caches.
//
// Quantum: the core runs ahead of SystemC until SystemC's next event, as ArmCpu does.  Interrupts
// are taken at a quantum's end, or at once when a bus access of the program raises the line or an
// instruction lets it in.
//
// WFI sleeps until an interrupt is pending that is enabled in mie, masked by mstatus or not.
//
// Boot: pc is the ELF's entry, mstatus and mtvec are 0, as GDB loads a program; sp is what the
// program sets.
//
// A trap goes to mtvec.  Of an exception there is a line to `log` (abort_log.h).  The program has
// failed, see fault(), if mtvec was never written, also by an interrupt; if it traps at its
// handler's first instruction, twice at the same place of its handler, in the data of its ELF, or a
// thousand times at the same instruction with the same registers; if its handler loops on one
// instruction for 100 ms; and as NiosVRunaway says.  It has ended where it loops on one instruction
// with all interrupts masked; by EBREAK, as newlib's exit() of the courses ends, which the debugger
// takes that has loaded it on the board; and without a handler by the environment call 93 (exit).
//
// Not handled: what caches and SDRAM cost; the vendor's manual has a table of clocks for integer
// instructions of Nios V/g ("Instruction Cycles") only from its edition 24.3.1 on, which was not
// at hand, so that those are guesses: a multiplication 3, a division 35, a branch that is taken and
// a jump 3, others 1.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "sim/cpu/abort_log.h"
#include "sim/cpu/answers.h"
#include "sim/cpu/elf.h"
#include "sim/cpu/nios_v_runaway.h"
#include "sim/cpu/program_cpu.h"
#include "sim/cpu/riscv/core.h"
#include "sim/cpu/run_ahead_time.h"
#include "sim/cpu/steady_bus.h"

namespace sim {

struct NiosVProgram {
    ElfProgram elf;
    double cpi = 1;  // 0.1 - 100: multiplies the clocks of each instruction
};

// A debugger.  Everything is called in the processor's thread, between two instructions, so all of
// the core may be read and changed.
class NiosVInspector {
public:
    // Once, with the program loaded, before its first instruction.
    virtual void on_start() = 0;
    // Before each quantum; true: it is to be one instruction.
    virtual bool on_quantum() = 0;
    // Before an EBREAK is a trap; true: done, the program goes on at pc.
    virtual bool on_breakpoint() = 0;
    // Before the program is ended because of this trap; true: it goes on at pc after all.
    virtual bool on_failure(std::uint32_t cause) = 0;
    // Before each quantum: true keeps interrupts waiting.
    virtual bool holds_interrupts() = 0;

protected:
    ~NiosVInspector() = default;
};

class NiosVCpu : public ProgramCpu, private RiscvBus {
public:
    using Log = std::function<void(const std::string&)>;

    NiosVCpu(const sc_core::sc_module_name& name, NiosVProgram program, Log log);

    RiscvCore& core() { return core_; }
    void attach(NiosVInspector* inspector) { inspector_ = inspector; }
    // Levels of the interrupts' lines, as bits of mip.
    void set_lines(std::uint32_t lines);
    std::uint32_t lines() const { return lines_; }
    // Lets reads of registers that cannot have changed be answered without an access.
    void set_steady_bus(SteadyBus* bus) { steady_bus_ = bus; }

    bool is_running() const { return sc_core::sc_get_current_process_handle() == process_; }
    std::optional<std::string> unfinished() const override;
    std::string accessed() const override;
    bool is_inspected() const override { return inspected_; }

    bool read_memory(std::uint32_t address, void* data, unsigned bytes) override;
    bool write_memory(std::uint32_t address, const void* data, unsigned bytes) override;
    void wake() override {
        woken_ = true;
        wake_.notify(sc_core::SC_ZERO_TIME);
    }

    Position position() override;
    Counts counts() const override;
    const ElfProgram& elf() const override { return program_.elf; }
    double cpi() const override { return program_.cpi; }
    sc_core::sc_time now() const override { return time_.now(); }
    std::uint32_t instruction() const override { return core_.pc(); }
    sc_core::sc_time ended_for() const override;
    void conclude() override;
    std::optional<int> exit_code() const { return exit_code_; }

private:
    bool read(std::uint32_t address, unsigned bytes, std::uint32_t& value) override;
    bool write(std::uint32_t address, unsigned bytes, std::uint32_t value) override;
    std::uint64_t cycles() override;

    void run();
    void map();
    void load();
    void sync();
    void run_on();
    void sleep();
    bool access(bool write, std::uint32_t address, unsigned bytes, std::uint32_t& value);
    bool answer_again(bool write, std::uint32_t address, unsigned bytes, std::uint32_t& value);
    bool inspect(bool write, std::uint32_t address, void* data, unsigned bytes);
    void take_interrupt();
    void trapped(const RiscvTrap& trap);
    std::string describe(const RiscvTrap& trap) const;
    bool ends(const RiscvTrap& trap);
    std::string hopeless(const RiscvTrap& trap);
    bool in_handler() const { return open_ && core_.returns() == open_->returns; }
    bool stands_still() const;
    void check();
    std::string where() const;
    std::string named(std::uint32_t address) const;
    std::string callers() const;

    using Time = RunAheadTime<RiscvCore, &RiscvCore::clocks>;

    NiosVProgram program_;
    Log log_;
    AbortLog abort_log_;
    RiscvCore core_;
    NiosVRunaway runaway_;
    Time time_;
    Counts counts_;
    NiosVInspector* inspector_ = nullptr;
    SteadyBus* steady_bus_ = nullptr;
    Answers answers_;
    std::uint64_t events_ = 0;  // of SystemC since which nothing is known to be the same

    std::uint32_t lines_ = 0;
    std::string bus_answer_;  // to the last access that was refused
    sc_core::sc_process_handle process_;
    bool running_ = false, waited_ = false, inspected_ = false, asleep_ = false, ended_ = false,
         woken_ = false;
    sc_core::sc_time asleep_since_;
    sc_core::sc_event wake_;
    std::optional<int> exit_code_;

    // The exception whose handler the program is in, if it has not returned since.
    struct Open {
        std::uint32_t cause;
        std::string text;
        std::uint64_t returns;
        sc_core::sc_time since;
        std::optional<sc_core::sc_time> spins_from;
    };
    std::optional<Open> open_;
    std::uint32_t nested_pc_ = 1, handler_ = 1;  // handler_: that was entered last
    std::array<std::uint32_t, 33> repeated_{};   // registers and pc of the last exception
    unsigned repetitions_ = 0;
    std::uint32_t polled_ = 0;  // the register that was read last
    unsigned polls_ = 0;        // how often in succession
    std::optional<sc_core::sc_time> over_since_;
    std::optional<Position> final_;
};

}  // namespace sim
