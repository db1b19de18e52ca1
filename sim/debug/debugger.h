// debugger.h - GDB at the processor: de1sim FILE.elf --gdb PORT.
//
//   build/bin/de1sim run s.yaml --elf p.elf --gdb 3333
//   gdb-multiarch p.elf -ex "target remote :3333"
//
// The processor waits before its first instruction until a debugger has connected.  While it is
// stopped, its thread blocks in the socket, so all of SystemC and simulated time stand still; only
// reads and writes of FPGA registers take the clocks that they need.  A run that is not stopped
// later gives the same files, byte for byte, as one without a debugger, but that the report counts
// what the debugger has read on the bus.
//
// A breakpoint stops before its instruction, a watchpoint before the load or store is done, as GDB
// expects of these processors.  Ctrl-C arrives within 1 ms of simulated time and ends a WFI.
// Single steps keep interrupts out (as QEMU's do), so stepping through a loop that waits for a
// handler does not end.  Device registers are read and written through the bus, in aligned words or
// halfwords where the request allows.  An access without a target is an error in the debugger, not
// in the program.
//
// The end of the run is reported as an exit with de1sim's code.  If the debugger detaches or the
// connection is lost, the run goes on without breakpoints.  A debugger that connects later stops
// it.  `kill` ends the run as Ctrl-C on the terminal does.  `monitor time`: the simulated time, and
// instructions so far.
//
// Here is what all processors share: the session, points, when it stops.  A processor's own half is
// a class derived of this one: arm_debugger.h, nios_v_debugger.h.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "sim/cpu/program_cpu.h"
#include "sim/debug/gdb_commands.h"
#include "sim/debug/gdb_connection.h"

namespace sim {

// GDB's numbers of signals (include/gdb/signals.def).
namespace gdb_signal {
constexpr unsigned INT = 2, ILL = 4, TRAP = 5, BUS = 10, SEGV = 11, SYS = 12, USR1 = 30, USR2 = 31,
                   UNKNOWN = 143;
}

class Debugger : protected GdbTarget {
public:
    virtual ~Debugger() = default;
    Debugger(const Debugger&) = delete;
    Debugger& operator=(const Debugger&) = delete;

    // Between two pieces of the run: Ctrl-C, or a new debugger.
    void poll();
    // The debugger has ended the run; SystemC is paused.
    bool killed() const { return killed_; }
    // The run is over.
    void ended(unsigned exit_code);

protected:
    // `given_up`: true once the run has been asked to end, so do not wait any longer.
    Debugger(ProgramCpu& cpu, GdbConnection& connection, std::function<bool()> given_up);

    // ---- For the processor's half, in the processor's thread ----

    // Before the first instruction.
    void begin();
    // Before each quantum; true: it is to be one instruction.
    bool quantum_begins();
    // While the program waits for ever.
    void idles();
    // Single steps keep interrupts out.
    bool keeps_interrupts_out() const { return stepping_ != 0 || hit_; }
    // Before the instruction at a breakpoint; true: stop there.
    bool reached();
    // Before a load or store of these bytes; true: stop there.
    bool touches_point(std::uint32_t address, unsigned bytes, bool write);
    // Lets a debugger that is connected look at what has happened; true: it has moved pc.
    bool stops_by(unsigned signal);

    std::uint32_t chosen() const { return chosen_; }

    // ---- What the processor's half is asked ----

    virtual std::uint32_t pc() const = 0;
    virtual std::uint64_t instructions() const = 0;  // since the beginning
    // RAM; false where there is none.
    virtual bool read_ram(std::uint32_t address, void* data, std::size_t bytes) = 0;
    virtual bool write_ram(std::uint32_t address, const void* data, std::size_t bytes) = 0;
    // From now on it is to call reached() at these addresses, and touches_point() or not.
    virtual void observe(const std::vector<std::uint32_t>& breaks, bool accesses) = 0;
    // The thread that runs; 0: all wait.
    virtual std::uint32_t running() const { return 1; }
    // Memory is that of this thread; 0: again of the one that runs.
    virtual void show_memory_of(std::uint32_t) {}
    // Of `monitor`, besides `time`: "" for what is not known, and one line for its help.
    virtual std::string own_monitor(std::string_view) { return ""; }
    virtual std::string own_monitor_help() const { return ""; }

private:
    enum class Resumed { BY_CLIENT, BY_ITSELF };

    std::size_t read(std::uint32_t address, void* data, std::size_t bytes) override;
    std::size_t write(std::uint32_t address, const void* data, std::size_t bytes) override;
    void insert(const GdbPoint& point) override;
    void remove(const GdbPoint& point) override;
    std::string stop_reply() override { return reply_; }
    std::string monitor(std::string_view command) override;
    std::uint32_t chosen_thread() override { return chosen_; }
    void choose_thread(std::uint32_t thread) override;

    std::uint32_t shown();
    std::string stopped_by(unsigned signal, const std::string& why = "");
    void stop(const std::string& reply);
    void serve();
    bool obey(const GdbAnswer& answer);
    void points_changed();
    void forget();

    ProgramCpu& cpu_;
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
