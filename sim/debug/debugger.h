// debugger.h - GDB at the processor: de1sim FILE.elf --gdb PORT.
//
//   build/bin/de1sim run s.yaml --elf p.elf --gdb 3333
//   gdb-multiarch p.elf -ex "target remote :3333"
//
// The processor waits before its first instruction until a debugger has connected.  While it is
// stopped, its thread blocks in the socket, so all of SystemC and simulated time stand still; only
// reads and writes of FPGA registers take the clocks that they need.  A run that is not stopped
// later gives the same files, byte for byte, as one without a debugger.
//
// A breakpoint stops before its instruction, a watchpoint before the load or store is done, as GDB
// expects of ARM.  Ctrl-C arrives within 1 ms of simulated time and ends a WFI.  Single steps keep
// interrupts out (as QEMU's do), so stepping through a loop that waits for a handler does not end.
// Memory is by physical address.  Device registers are read and written through the bus, in aligned
// words or halfwords where the request allows.  An access without a target is an error in the
// debugger, not in the program.
//
// Stops by itself: a BKPT instruction (SIGTRAP), an exception that the program has no vector for
// (SIGILL, SIGSEGV, SIGSYS).  A Linux program: before a signal ends it, before an oops of a module
// does (SIGSEGV), and before it ends because all threads wait for each other (SIGABRT).  The end of
// the run is reported as an exit with de1sim's code.
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
// If the debugger detaches or the connection is lost, the run goes on without breakpoints.  A
// debugger that connects later stops it.  `kill` ends the run as Ctrl-C on the terminal does.
// `monitor time`: the simulated time, and instructions so far.
//
// Costs nothing until a point is set.  A breakpoint costs time when it is reached.  A watchpoint is
// checked at every load and store, about 10 ns each.
//
// Not handled: translation tables that are not flat, banked registers of other modes, CP15,
// thread-local variables by their names, the files of other programs that processes become, one
// thread that goes on alone (`set scheduler-locking on`).
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "sim/cpu/arm_cpu.h"
#include "sim/debug/gdb_commands.h"
#include "sim/debug/gdb_connection.h"

namespace sim {

class Debugger final : public ArmInspector, private ArmProbe, private ArmWatch, private GdbTarget {
public:
    // Attaches itself.  `given_up`: true once the run has been asked to end, so do not wait any
    // longer.
    Debugger(ArmCpu& cpu, GdbConnection& connection, std::function<bool()> given_up);
    ~Debugger();

    // Between two pieces of the run: Ctrl-C, or a new debugger.
    void poll();
    // The debugger has ended the run; SystemC is paused.
    bool killed() const { return killed_; }
    // The run is over.
    void ended(unsigned exit_code);

    void on_start(ArmCore& core) override;
    std::uint64_t on_quantum(ArmCore& core, std::uint64_t limit) override;
    bool on_exception(ArmCore& core, ArmException exception, const ArmFault& fault) override;
    bool on_failure(ArmCore& core, ArmException exception) override;
    void on_end(ArmCore& core, unsigned signal) override;
    void on_idle(ArmCore& core) override;
    bool holds_interrupts() override { return stepping_ != 0 || hit_; }

private:
    enum class Resumed { BY_CLIENT, BY_ITSELF };

    bool before(std::uint32_t) override;
    bool touched(std::uint32_t address, unsigned bytes, bool write) override;

    std::uint64_t reg(unsigned number) override;
    void set_reg(unsigned number, std::uint64_t value) override;
    std::size_t read(std::uint32_t address, void* data, std::size_t bytes) override;
    std::size_t write(std::uint32_t address, const void* data, std::size_t bytes) override;
    void insert(const GdbPoint& point) override;
    void remove(const GdbPoint& point) override;
    std::string stop_reply() override { return reply_; }
    std::string monitor(std::string_view command) override;
    std::uint32_t displacement() override;
    std::vector<GdbThread> threads() override;
    std::uint32_t chosen_thread() override { return chosen_; }
    void choose_thread(std::uint32_t thread) override;

    std::uint32_t running() const;
    std::uint32_t shown() const;
    std::string stopped_by(unsigned signal, const std::string& why = "");
    ArmRegisters* saved();
    std::string modules() const;
    void stop(const std::string& reply);
    void serve();
    bool obey(const GdbAnswer& answer);
    void points_changed();
    void forget();

    ArmCpu& cpu_;
    ArmCore& core_;
    GdbConnection& connection_;
    const std::function<bool()> given_up_;

    std::vector<GdbPoint> points_;
    std::string reply_;          // why it stopped last
    std::uint32_t stopped_ = 1;  // the thread that reply_ names
    std::uint32_t chosen_ = 1;   // by the debugger
    Resumed resumed_ = Resumed::BY_ITSELF;
    std::uint64_t resumed_at_ = 0;      // instructions
    std::uint32_t resumed_thread_ = 1;  // that ran then
    std::uint32_t stepping_ = 0;        // this thread; 0: none
    bool stepped_ = false;              // it has executed its instruction
    std::uint64_t quantum_begin_ = 0;   // instructions before the quantum
    std::uint32_t quantum_thread_ = 1;  // that ran in it
    bool interrupt_ = false;            // asked for
    bool unread_ = false;               // the connection's packet waits for an answer
    bool hit_ = false;                  // a point, reported by reply_
    bool killed_ = false;
    // The stop reply names a breakpoint's stop as such, as GDB asks.  Without that, GDB may
    // mistake a breakpoint for one thread, reached by another, for a signal of the program.
    bool names_breaks_ = false;
};

}  // namespace sim
