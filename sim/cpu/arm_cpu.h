// arm_cpu.h - the HPS's Cortex-A9 running the board's own ELF, as a TLM initiator in quanta.
//
// Time: an instruction takes CPI clocks of 800 MHz.  A bus access takes in addition what its target
// says; accesses to RAM are included in the CPI.  CPI is 1 unless --cpi says otherwise: the A9
// issues up to two instructions per clock, and in other clocks it waits for its caches.  Neither is
// modelled, and 1 is a value between the two.  The CPI of a real program is cycles / instructions,
// measured on the board with the PMU.
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
// Stores to memory on the HPS-to-FPGA bridge that the translation tables call Normal are merged as
// in the A9's store buffer: consecutive stores at rising addresses become one burst, up to the next
// multiple of 64 bytes.  The burst is sent before the next other access, which keeps the program's
// order, or at the quantum's end.  The first store into a page of 4 KB is not merged, so that a
// store without a target aborts at its own instruction.
//
// WFI sleeps until the interrupt controller raises IRQ or FIQ, masked or not.  WFE sleeps for 1 us
// or until then: no other core can send an event, because they are in reset, and a spurious wake-up
// is allowed.  SEV does nothing.
//
// A loop that does the same in every round, but for what it counts (steady_loop.h), is not executed
// round by round: the state and the time after many of them are computed.  That cannot be seen from
// outside, nor by the program: all counts and times are those of the rounds (arm_shortcuts.cpp).
//
// Boot: pc is the ELF's entry, SVC mode, interrupts off, VFP and NEON off, SP at the top of DDR3.
//
// An access without a target is a data abort in the program, and a line to `log` (abort_log.h).  A
// program has failed, see fault(), if it has no vector for an exception (the table's word is 0 or
// there is no memory), if it faults in the vector table, or if it faults repeatedly at the same
// place of its abort handler.
//
// The message of a program that has failed names the callers of its last function: LR, and the last
// five words on the stack that are return addresses of a BL or BLX.  So it may name a function that
// has returned long ago.
//
// A program that takes an abort or an undefined instruction must return from it: leave the mode
// of its handler, ABT or UND, for another than IRQ and FIQ.  Otherwise it has failed:
//   - at once when it has looped on one instruction (b .) in that mode for 100 ms, with IRQ masked;
//   - at once when its handler has returned to the same instruction with the same registers a
//     thousand times;
//   - when the run ends while it loops on one instruction, or is still in that mode more than 1 ms
//     after the exception: unfinished().
// So a handler may take its time, print, sleep and be interrupted, as long as it comes to an end.
//
// Some errors cause no exception, so a program has also failed
//   - when it went into the data of its ELF (ElfSection::is_data), and there takes an abort or an
//     undefined instruction, or stands still on a word that it has not written;
//   - when it executes zeros (ArmStop::RAN_OFF);
//   - when its stack grows below the memory that it was in, or into its code; this is checked after
//     each quantum.
//
// Deterministic: nothing depends on the host's time.
//
// Not handled: see arm_core.h.  A handler that changes its mode to SVC or SYS and stays there
// counts as left.  A handler that loops until a watchdog resets the board must be reset within
// those 100 ms.  A stack that grows into data, or in a program without a section table, is not
// seen.  Instructions that a program writes are executed at once, as without caches: that it
// forgets to maintain them is not seen.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sim/cpu/abort_log.h"
#include "sim/cpu/answers.h"
#include "sim/cpu/arm_core.h"
#include "sim/cpu/arm_exceptions.h"
#include "sim/cpu/elf.h"
#include "sim/cpu/processor.h"
#include "sim/cpu/steady_bus.h"
#include "sim/cpu/steady_loop.h"

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
    // Before each quantum: true keeps IRQ and FIQ waiting.
    virtual bool holds_interrupts() { return false; }

protected:
    ~ArmInspector() = default;
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

protected:
    ~ArmKernel() = default;
};

class ArmCpu : public Processor, private ArmBus {
public:
    using Log = std::function<void(const std::string&)>;
    static constexpr std::uint32_t STACK = 0x3FFFFFF8;  // SP at the start: top of DDR3

    ArmCpu(const sc_core::sc_module_name& name, ArmProgram program, Log log);

    void attach(ArmInspector* inspector) { inspector_ = inspector; }
    void attach(ArmKernel* kernel) { kernel_ = kernel; }
    ArmCore& core() { return core_; }

    // Answers a program's requests to a debugger, pc after each.  Without it, and with a kernel,
    // they are supervisor calls like others.
    void set_semihosting(std::function<void(ArmCore&)> answer) { semihosting_ = std::move(answer); }

    void interrupt(bool irq, bool fiq) override;
    void warm_reset() override;
    // Ends a WFI or WFE, as a debug event does.
    void wake() { wake_.notify(sc_core::SC_ZERO_TIME); }

    // The program's time: SystemC's plus what it has run of its quantum.
    sc_core::sc_time now() const {
        const std::uint64_t run = core_.instructions() - accounted_;
        return sc_core::sc_time_stamp() + ahead_ +
               sc_core::sc_time::from_value(run * instruction_ps_);
    }

    // It is the processor that is at it now, no other process of SystemC.
    bool is_running() const { return sc_core::sc_get_current_process_handle() == process_; }

    std::optional<std::string> unfinished() const override;
    std::string accessed() const override;
    bool is_inspected() const override { return inspected_; }

    // At the run's end: logs what is still to be said of the program's aborts.  position() stays.
    void conclude();

    // How long the program has been over: ended by end(), or looping on one instruction with IRQ
    // and FIQ masked, so that only a reset could end the loop.  0 before, and under an
    // inspector.
    sc_core::sc_time ended_for() const;

    // Lets loops that use the bus be shortened, too.
    void set_steady_bus(SteadyBus* bus) { steady_bus_ = bus; }
    // Executes every round.
    void leave_no_rounds_out() { shortcuts_ = false; }

    // For an inspector: reads as the program would, RAM and registers alike, in no time.  False: no
    // target answers.
    bool read_memory(std::uint32_t address, void* data, unsigned bytes);
    bool write_memory(std::uint32_t address, const void* data, unsigned bytes);

    // For a kernel and for semihosting: lets time pass while the program sleeps; ends the program,
    // with a fault if `why` is not empty.
    void pause(const sc_core::sc_time& time);
    void pause(const sc_core::sc_event& until, const sc_core::sc_time& at_most);
    // For a kernel: the processor works for this long, besides what the program executes.
    void work(const sc_core::sc_time& time);
    // For a kernel: when its alarm() is called, once, in the program's time.
    void set_alarm(const sc_core::sc_time& at) { alarm_ = at; }
    const sc_core::sc_time& alarm() const { return alarm_; }
    void end(const std::string& why = "");
    std::string where() const;  // "at 12.345678 ms, PC 0x00001234 in main+0x10"

    struct Position {
        std::uint32_t pc;
        std::string function;                 // "main+0x10", "" if it is in none
        bool sleeping;                        // in WFI, or in pause()
        bool ended;                           // by end()
        std::optional<std::uint32_t> polled;  // a register that a loop reads
    };
    Position position();

    struct Counts {
        std::uint64_t instructions = 0;
        std::uint64_t interrupts = 0;  // taken, IRQ and FIQ
        std::uint64_t aborts = 0;      // taken, data and prefetch
        sc_core::sc_time asleep;       // in WFI and WFE
        sc_core::sc_time on_bus;       // waiting for targets, and for registers to change
    };
    Counts counts() const;
    const ArmProgram& program() const { return program_; }

private:
    bool read(std::uint32_t address, unsigned bytes, std::uint32_t& value) override;
    bool write(std::uint32_t address, unsigned bytes, std::uint32_t value) override;
    bool write_normal(std::uint32_t address, unsigned bytes, std::uint32_t value) override;
    bool passes_wfi() override { return irq_ || fiq_ || reset_; }
    void unmasked() override;

    static sc_core::sc_time spin_limit() { return {100, sc_core::SC_MS}; }
    static sc_core::sc_time handler_grace() { return {1, sc_core::SC_MS}; }
    static sc_core::sc_time wait_timeout() { return {1, sc_core::SC_US}; }
    // How far the core may run ahead: to SystemC's next event or the alarm, but 100 us at most.
    sc_core::sc_time horizon() const;

    void run();
    void map(std::uint64_t first, std::uint64_t last);
    void direct_access_changed(sc_dt::uint64 first, sc_dt::uint64 last) override;
    void load();
    void start();
    void account();
    void sync();
    std::uint64_t budget() const;
    bool quantum_ends() const;
    void run_on();
    void sleep(const sc_core::sc_time& at_most);
    template <class... Until>
    void pause_until(const Until&... until);
    std::uint64_t epoch() const;
    std::uint64_t pass_rounds(std::uint64_t most);
    bool pass_memory(std::uint64_t most);
    bool pass_bus();
    bool go_round(std::uint64_t& time, std::uint64_t end);
    void passed(std::uint64_t rounds);
    std::optional<std::uint32_t> polled();
    SteadyLoop::Registers loop_registers() const;
    // In an access that waits the core's own is not exact.
    std::uint32_t present_pc() const { return running_ ? core_.instruction() : core_.pc(); }
    void drain();
    bool is_replayed();
    void remember_access(std::uint32_t address, unsigned bytes, bool write, std::uint32_t value);
    bool access(tlm::tlm_command command, std::uint32_t address, unsigned bytes, void* data);
    bool inspect(tlm::tlm_command command, std::uint32_t address, void* data, unsigned bytes);
    std::optional<ArmException> pending_interrupt()
        const;  // the interrupt that is pending and not masked
    void take_interrupt();
    void handle(ArmStop stop);
    void raise(ArmException exception, std::uint32_t status, const std::string& what);
    bool unhandled(ArmException exception);
    bool in_handler() const;
    void left_handler();
    bool spins() const;
    bool stands_still() const;
    void count_repetition();
    std::string failure() const;
    void fail_runaway(const std::string& what);
    const ElfSection* data_at(std::uint32_t address) const;
    bool enters_data();
    std::string in_data(const ElfSection& data, const std::string& what) const;
    bool is_as_loaded(std::uint32_t address) const;
    std::string stack_overflow(std::uint32_t lowest, bool through) const;
    void check_runaway();
    std::string callers() const;
    std::string missing_code() const;
    std::string undefined() const;
    std::string unaligned() const;
    void check_end();
    void check_failure();

    ArmProgram program_;
    Log log_;
    AbortLog abort_log_;
    ArmCore core_;
    ArmInspector* inspector_ = nullptr;
    bool inspected_ = false;
    std::optional<Position> final_;  // where it was when the run ended
    ArmKernel* kernel_ = nullptr;
    std::function<void(ArmCore&)> semihosting_;
    const std::uint64_t instruction_ps_;
    struct Range {
        std::uint64_t first, last;
    };
    std::vector<Range> mapped_;                 // one for each call of the core
    std::optional<Range> remap_;                // whose direct access has changed
    bool running_ = false;                      // in ArmCore::run()
    sc_core::sc_process_handle process_;        // run()
    std::uint64_t inspected_end_ = UINT64_MAX;  // count at which the inspector stops it

    sc_core::sc_time alarm_ = sc_core::sc_max_time();
    sc_core::sc_time ahead_;       // of SystemC's time, as far as accounted
    std::uint64_t accounted_ = 0;  // instructions
    Counts counts_;

    bool irq_ = false, fiq_ = false, reset_ = false, asleep_ = false, ended_ = false;
    sc_core::sc_time asleep_since_;
    sc_core::sc_event wake_;

    class LoopWorld;
    bool shortcuts_ = true;
    SteadyBus* steady_bus_ = nullptr;
    SteadyLoop loop_;
    Answers answers_;
    std::uint64_t epoch_before_ = 0;    // the last access
    std::uint64_t events_ = 0;          // how often time has passed in SystemC
    bool waited_ = false;               // ... in an access, so the quantum ends with it
    std::vector<std::uint64_t> again_;  // ends of the next accesses, the last first; see pass_bus()
    unsigned looks_ = 0, pause_ = 0, longest_pause_ = 0;
    struct NoLoop {
        std::uint32_t pc = 1;
        unsigned times = 0;  // that none was found there
    };
    std::array<NoLoop, 64> no_loop_;
    struct StoreBuffer {
        std::uint32_t begin = 0, bytes = 0;
        std::uint32_t page = 1;  // of 4 KB, that is known to answer; 1 is none
        std::array<std::uint8_t, 64> data;
    } stores_;
    std::string bus_answer_;             // to the last access that was refused
    std::uint32_t refused_address_ = 0;  // on the bus
    unsigned refused_bytes_ = 0;
    std::uint32_t nested_pc_ = 1;  // of the last abort within an abort

    struct Open {
        ArmException exception;
        std::string text;             // what and where it was
        sc_core::sc_time since;       // taken
        sc_core::sc_time spins_from;  // loops on one instruction; now, if it does not
    };
    // An exception that repeats: the registers with which it happened, and how often.  From
    // MANY_REPETITIONS on its handler is executed in single steps.
    static constexpr unsigned MANY_REPETITIONS = 1000;
    std::array<std::uint32_t, 17> repeated_state_{};
    unsigned repetitions_ = 0;

    struct Stack {
        std::uint32_t top = 0, now = 0;  // r13: its highest value seen, its present one
    };
    std::array<Stack, 16> stacks_;  // of each mode, by CPSR[3:0]

    std::string entered_data_;                    // where and by whom, while it is there
    std::optional<sc_core::sc_time> over_since_;  // see ended_for()
    std::optional<Open> open_;                    // the exception whose handler it is in
};

}  // namespace sim
