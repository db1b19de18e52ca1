// arm_cpu.h - the HPS's Cortex-A9 running the board's own ELF, as a TLM initiator in quanta.
//
// It is made of ArmCore, which executes instructions, and of
//   ArmTime       how far it is ahead of SystemC's time
//   StoreBuffer   stores that become one burst
//   WordBurst     words of one instruction that become one
//   ArmShortcuts  rounds of loops that need not be executed
//   ArmHandlers   programs that do not return from an abort
//   ArmRunaway    programs whose PC or stack is where it cannot belong
//
// Quantum: the core runs ahead of SystemC until SystemC's next event, so never past a timer's
// expiry, a pin that the board changes or a scan line.  Interrupts are taken at a quantum's end,
// which is
//   - at once when a bus access of the program raises the line,
//   - at the expiry of a timer, exactly,
//   - within 32 us (a scan line) of an event inside the fabric,
//   - at once when the program enables interrupts with the line already up (with Unicorn's core,
//     within 64 instructions).
//
// A bus access takes, besides its instruction, what its target says; accesses to RAM are included
// in the CPI.
//
// WFI sleeps until the interrupt controller raises IRQ or FIQ, masked or not.  WFE sleeps for 1 us
// or until then: no other core can send an event, because they are in reset, and a spurious wake-up
// is allowed.  SEV does nothing.
//
// Boot: pc is the ELF's entry, SVC mode, interrupts off, VFP and NEON off, SP at the top of DDR3.
//
// An access without a target is a data abort in the program, and a line to `log` (abort_log.h).  A
// program has failed, see fault(), if it has no vector for an exception (the table's word is 0 or
// there is no memory), if it faults in the vector table, if it faults repeatedly at the same place
// of its abort handler, if it executes zeros (ArmStop::RAN_OFF), and as ArmHandlers and ArmRunaway
// say.
//
// Deterministic: nothing depends on the host's time.
//
// Not handled: see arm_core.h.  Instructions that a program writes are executed at once, as without
// caches: that it forgets to maintain them is not seen.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sim/cpu/arm_core.h"
#include "sim/cpu/arm_exceptions.h"
#include "sim/cpu/arm_handlers.h"
#include "sim/cpu/arm_runaway.h"
#include "sim/cpu/arm_shortcuts.h"
#include "sim/cpu/arm_time.h"
#include "sim/cpu/elf.h"
#include "sim/cpu/program_cpu.h"
#include "sim/cpu/steady_bus.h"
#include "sim/cpu/store_buffer.h"
#include "sim/cpu/word_burst.h"

namespace sim {

struct ArmProgram {
    ElfProgram elf;
    double cpi = 1;  // clocks per instruction, 0.1 - 100; rounded to whole picoseconds
};

// Inspects the processor: a debugger, a kernel's emulation, a profiler.  Everything is called in
// the processor's thread, outside of ArmCore::run(), so all of the core may be read and changed.
class ArmInspector {
public:
    // Once, with the program loaded, before its first instruction.
    virtual void on_start(ArmCore&) {}
    // Before each quantum of `limit` instructions; returns how many to run instead, at most that.
    virtual std::uint64_t on_quantum(ArmCore&, std::uint64_t limit) { return limit; }
    // A supervisor call, pc after it; true: done, the program goes on at pc.
    virtual bool on_svc(ArmCore&) { return false; }
    // Before any other synchronous exception is entered; true: done, the program goes on at pc.
    virtual bool on_exception(ArmCore&, ArmException, const ArmFault&) { return false; }
    // Before the program is ended because of an exception; true: it goes on at pc after all.
    virtual bool on_failure(ArmCore&, ArmException) { return false; }
    // A kernel is about to end the program, as by this signal of Linux's.
    virtual void on_end(ArmCore&, unsigned) {}
    // No thread of a kernel can run; after wake(), and each time that the kernel looks again.
    virtual void on_idle(ArmCore&) {}
    // Before each quantum: true keeps IRQ and FIQ waiting.
    virtual bool holds_interrupts() { return false; }

protected:
    ~ArmInspector() = default;
};

// What a debugger shows of a kernel.
struct ArmThread {
    unsigned number;          // from 1
    std::string name, state;  // "tick"; "waits for standard input"
};
struct ArmModule {
    std::string name;
    std::filesystem::path file;  // ELF, on the host, its addresses final; empty: there is none
};

// An operating system that the simulator emulates: programs run in its address space and call it.
// Called like an ArmInspector, and after it.  With a kernel, interrupts stay masked.
class ArmKernel {
public:
    // Replaces the memory map, the loading and the boot that this header describes; called after a
    // warm reset, too.
    virtual void boot(ArmCore&) = 0;
    // A supervisor call, pc after it.
    virtual void call(ArmCore&) = 0;
    // Any other synchronous exception, pc at it; `what` describes it in words.
    virtual void exception(ArmCore&, ArmException, const ArmFault&, const std::string& what) = 0;
    // At the time of ArmCpu::set_alarm(), between two instructions.
    virtual void alarm(ArmCore&) {}
    // The interrupt controller's IRQ has risen, perhaps within an access of the program.
    virtual void interrupt_raised() {}
    // Something may end a loop on one instruction by itself: a signal, another thread.
    virtual bool may_interrupt() const { return false; }

    // For a debugger, outside of ArmCore::run().
    // The threads of all processes and modules, those of the first process first; none before
    // boot().
    virtual std::vector<ArmThread> thread_list() const { return {}; }
    // The number of the thread whose registers the core has; 0: all wait.
    virtual unsigned running_thread() const { return 0; }
    // Those of another thread, which may be changed; nullptr for the running one, and if there is
    // no such thread.  Valid until a thread runs.
    virtual ArmRegisters* saved_registers(unsigned) { return nullptr; }
    // The core sees the memory of this thread; 0: again what it saw before, which has to be the
    // case when the program goes on.  A number that is no thread's changes nothing.
    virtual void show_memory_of(unsigned) {}
    // The modules that are loaded.
    virtual std::vector<ArmModule> module_list() const { return {}; }

protected:
    ~ArmKernel() = default;
};

class ArmCpu : public ProgramCpu, private ArmBus {
public:
    using Log = std::function<void(const std::string&)>;
    static constexpr std::uint32_t STACK = 0x3FFFFFF8;  // SP at the start: top of DDR3

    ArmCpu(const sc_core::sc_module_name& name, ArmProgram program, Log log);

    void attach(ArmInspector* inspector) { inspector_ = inspector; }
    void attach(ArmKernel* kernel) { kernel_ = kernel; }
    ArmKernel* kernel() const { return kernel_; }  // or nullptr
    ArmCore& core() { return core_; }

    // Answers a program's requests to a debugger, pc after each.  Without it, and with a kernel,
    // they are supervisor calls like others.
    void set_semihosting(std::function<void(ArmCore&)> answer) { semihosting_ = std::move(answer); }

    void interrupt(bool irq, bool fiq) override;
    bool irq() const { return irq_; }
    void asynchronous_abort(const std::string& what, bool slave_error) override;
    void warm_reset() override;
    void hold_in_reset(bool held) override;
    // A WFI or WFE; and has a kernel that waits look again.
    void wake() override {
        wake_.notify(sc_core::SC_ZERO_TIME);
        inspect_.notify(sc_core::SC_ZERO_TIME);
    }

    sc_core::sc_time now() const override { return time_.now(); }

    // It is the processor that is at it now, no other process of SystemC.
    bool is_running() const { return sc_core::sc_get_current_process_handle() == process_; }

    std::optional<std::string> unfinished() const override;
    std::string accessed() const override;
    bool is_inspected() const override { return inspected_; }

    void conclude() override;

    // How long the program has been over: ended by end(), or looping on one instruction with IRQ
    // and FIQ masked, so that only a reset could end the loop; and under a kernel nothing else may
    // happen.  0 before, and under an inspector.
    sc_core::sc_time ended_for() const override;

    // Lets loops that use the bus be shortened, too.
    void set_steady_bus(SteadyBus* bus) { shortcuts_.set_bus(bus); }
    // Words that one instruction loads from the FPGA's bridges, or stores there, are one
    // transaction; and all there have AxiAttributes.
    void show_bursts();
    // Executes every round.
    void leave_no_rounds_out() { shortcuts_.disable(); }

    bool read_memory(std::uint32_t address, void* data, unsigned bytes) override;
    bool write_memory(std::uint32_t address, const void* data, unsigned bytes) override;

    // For a kernel and for semihosting: lets time pass while the program sleeps; ends the program,
    // with a fault if `why` is not empty.
    void pause(const sc_core::sc_time& time);
    void pause(const sc_core::sc_event& until, const sc_core::sc_time& at_most);
    // For a kernel: the processor works for this long, besides what the program executes.
    void work(const sc_core::sc_time& time);
    // For a kernel: when its alarm() is called, once, in the program's time.
    void set_alarm(const sc_core::sc_time& at) { time_.set_alarm(at); }
    const sc_core::sc_time& alarm() const { return time_.alarm(); }
    // Before that, a kernel shows an inspector what ends it: a signal, by Linux's number.
    void show_end(unsigned signal) {
        if (inspector_) inspector_->on_end(core_, signal);
    }
    void end(const std::string& why = "");
    std::string where() const;  // "at 12.345678 ms, PC 0x00001234 in main+0x10"

    Position position() override;

    Counts counts() const override;
    std::uint32_t instruction() const override { return core_.instruction(); }
    const ElfProgram& elf() const override { return program_.elf; }
    double cpi() const override { return program_.cpi; }
    const ArmProgram& program() const { return program_; }
    // Its names are in messages from now on.
    void add_library(ElfProgram library) { program_.elf.libraries.push_back(std::move(library)); }

private:
    bool read(std::uint32_t address, unsigned bytes, std::uint32_t& value) override;
    bool write(std::uint32_t address, unsigned bytes, std::uint32_t value) override;
    bool write_normal(std::uint32_t address, unsigned bytes, std::uint32_t value) override;
    bool exclusive_stored() override;
    bool passes_wfi() override { return irq_ || fiq_ || abort_ || reset_; }
    void unmasked() override;

    static sc_core::sc_time wait_timeout() { return {1, sc_core::SC_US}; }

    void run();
    void map(std::uint64_t first, std::uint64_t last);
    void direct_access_changed(sc_dt::uint64 first, sc_dt::uint64 last) override;
    void load();
    void start();
    void sync();
    std::uint64_t budget() const;
    std::uint64_t shortened(std::uint64_t most);
    bool quantum_ends() const;
    void run_on();
    void sleep(const sc_core::sc_time& at_most);
    template <class... Until>
    void pause_until(const Until&... until);
    // In an access that waits the core's own is not exact.
    std::uint32_t present_pc() const { return running_ ? core_.instruction() : core_.pc(); }
    void drain();
    bool is_replayed();
    bool joins(std::uint32_t address, unsigned bytes);
    bool write_now(std::uint32_t address, unsigned bytes, std::uint32_t value);
    void describe_access();
    bool access(tlm::tlm_command command, std::uint32_t address, unsigned bytes, void* data);
    bool inspect(tlm::tlm_command command, std::uint32_t address, void* data, unsigned bytes);
    std::optional<ArmException> pending_interrupt() const;  // and not masked
    void take_interrupt();
    void handle(ArmStop stop);
    void raise(ArmException exception, std::uint32_t status, const std::string& what);
    std::string missing_code() const;
    std::string callers() const;
    void fail_runaway(const std::string& what);
    void check();

    ArmProgram program_;
    Log log_;
    ArmCore core_;
    ArmTime time_;
    StoreBuffer stores_;
    AxiAttributes stored_;  // of those stores
    bool shows_bursts_ = false;
    bool exclusive_failed_ = false;  // and has been reported
    WordBurst burst_;
    ArmShortcuts shortcuts_;
    ArmHandlers handlers_;
    ArmRunaway runaway_;
    Counts counts_;

    ArmInspector* inspector_ = nullptr;
    bool inspected_ = false;                    // by inspect()
    std::uint64_t inspected_end_ = UINT64_MAX;  // count at which the inspector stops it
    ArmKernel* kernel_ = nullptr;
    std::function<void(ArmCore&)> semihosting_;

    struct Range {
        std::uint64_t first, last;
    };
    std::vector<Range> mapped_;          // one for each call of the core
    std::optional<Range> remap_;         // whose direct access has changed
    std::string bus_answer_;             // to the last access that was refused
    std::uint32_t refused_address_ = 0;  // on the bus
    unsigned refused_bytes_ = 0;

    sc_core::sc_process_handle process_;  // run()
    bool running_ = false;                // in ArmCore::run()
    bool waited_ = false;                 // in an access, so the quantum ends with it
    struct Abort {
        std::string what;
        std::uint32_t status;
    };
    std::optional<Abort> abort_;  // asynchronous, and not taken yet
    bool irq_ = false, fiq_ = false, reset_ = false, held_ = false;
    bool asleep_ = false, ended_ = false;
    sc_core::sc_time asleep_since_;
    sc_core::sc_event wake_, inspect_, released_;  // inspect_: by wake() only
    std::optional<Position> final_;                // where it was when the run ended
    std::optional<sc_core::sc_time> over_since_;   // see ended_for()
};

}  // namespace sim
