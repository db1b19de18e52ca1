// arm_core.h - the Cortex-A9's instructions, by Unicorn: runs, counts, stops exactly where asked.
//
// No SystemC here, and no time.  RAM is shared with whoever owns it; all other addresses go to an
// ArmBus, one call an aligned access of 1, 2 or 4 bytes (longer ones are split, low address first).
// run() comes back before an instruction, never within one, with `pc` exact.
//
// Exceptions are not entered here: run() says what happened, arm_exceptions.h enters the vector.
//
// Costs 2 - 3 ns of the host an instruction, 50 ns more each store to RAM (Unicorn 2.0.1 checks
// every one for code), 40 ns each bus access beside what the bus takes, 0.3 us a call of run().
//
// Not handled: the second core; caches (instructions that maintain them do nothing); PMCCNTR
// (reads 0); SMC and HVC are undefined instructions.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

namespace sim {

// What the core sees beyond RAM.  Called in the middle of run(): registers are those before the
// instruction, and nothing of the core may be changed but by stop_soon().
class ArmBus {
public:
    // False: nobody answers.  The instruction then has no effect and run() ends with DATA_ABORT.
    virtual bool read(std::uint32_t address, unsigned bytes, std::uint32_t& value) = 0;
    virtual bool write(std::uint32_t address, unsigned bytes, std::uint32_t value) = 0;

protected:
    ~ArmBus() = default;
};

// A debugger's breakpoints, a profiler's counts.
class ArmProbe {
public:
    // Before the instruction at `pc`; true ends run() before it, with LIMIT.
    virtual bool before(std::uint32_t pc) = 0;

protected:
    ~ArmProbe() = default;
};

// A debugger's watchpoints.
class ArmWatch {
public:
    // Within the load or store, once each of its accesses; true ends run() with LIMIT and pc at it.
    // Its registers and what it would do on the bus are then undone; a store to RAM is not.
    virtual bool touched(std::uint32_t address, unsigned bytes, bool write) = 0;

protected:
    ~ArmWatch() = default;
};

enum class ArmStop {
    LIMIT,           // all instructions done, or stop_soon()
    WFI,             // pc is behind it
    WFE,             // pc is behind it
    SVC,             // pc is behind it
    UNDEFINED,       // pc is at it
    BREAKPOINT,      // BKPT; pc is at it
    PREFETCH_ABORT,  // pc is where no instruction can be read from
    DATA_ABORT,      // pc is at the load or store
};

struct ArmFault {
    std::uint32_t address = 0;  // of the data
    bool write = false;
    bool mmu = false;  // refused by the translation tables or where nothing is mapped
};

// Numbers of the exceptions' modes in the CPSR.
namespace arm_mode {
constexpr std::uint32_t USR = 0x10, FIQ = 0x11, IRQ = 0x12, SVC = 0x13, ABT = 0x17, UND = 0x1b,
                        SYS = 0x1f;
}

namespace arm_cpsr {
constexpr std::uint32_t T = 1u << 5, F = 1u << 6, I = 1u << 7, A = 1u << 8, E = 1u << 9,
                        J = 1u << 24, IT = 0x0600fc00, MODE = 0x1f;
}

// What programs may do with memory.
namespace arm_access {
constexpr unsigned READ = 1, WRITE = 2, EXECUTE = 4, ALL = 7;
}

// A register of coprocessor 15: MRC p15, op1, Rt, CRn, CRm, op2.
struct Cp15 {
    unsigned crn, op1, crm, op2;
};

namespace cp15 {
constexpr Cp15 SCTLR{1, 0, 0, 0}, CPACR{1, 0, 0, 2}, SCR{1, 0, 1, 0}, DFSR{5, 0, 0, 0},
    IFSR{5, 0, 0, 1}, DFAR{6, 0, 0, 0}, IFAR{6, 0, 0, 2}, VBAR{12, 0, 0, 0}, TPIDRURO{13, 0, 0, 3},
    CBAR{15, 4, 0, 0};
}

class ArmCore {
public:
    explicit ArmCore(ArmBus& bus);
    ~ArmCore();

    // All in multiples of 4096 bytes, and not in run().  `bus_base` is what the bus calls `base`;
    // what is unmapped was mapped by one call.  `access` is a sum of arm_access.
    void map_ram(std::uint32_t base, std::uint64_t size, void* bytes,
                 unsigned access = arm_access::ALL);
    void map_bus(std::uint32_t base, std::uint64_t size, std::uint32_t bus_base,
                 unsigned access = arm_access::READ | arm_access::WRITE);
    void unmap(std::uint32_t base, std::uint64_t size);
    // What the bus calls `address`, if that is mapped to the bus.
    std::optional<std::uint32_t> bus_address(std::uint32_t address) const;

    // Sees every instruction; nullptr takes it away.
    void attach(ArmProbe* probe) { probe_ = probe; }
    // Sees every load and store; nullptr takes it away.  Not in run().
    void watch(ArmWatch* watch);

    // SVC mode, interrupts off, VFP and NEON on, MMU and caches off; `entry` bit 0 is Thumb.
    void reset(std::uint32_t entry, std::uint32_t stack);

    // Runs at most `limit` instructions.
    ArmStop run(std::uint64_t limit);
    // From the bus: run() ends before the next instruction.
    void stop_soon() { limit_ = count_; }
    // From the bus: run() ends when `left` instructions behind the present one are done.
    void stop_after(std::uint64_t left) { limit_ = count_ + left; }

    std::uint64_t instructions() const { return count_; }   // since the beginning
    const ArmFault& fault() const { return fault_; }        // of the last abort
    std::uint32_t instruction() const { return last_pc_; }  // the one in progress, or the last

    std::uint32_t pc() const { return reg(15); }
    std::uint32_t reg(unsigned number) const;  // r0 - r15 of the present mode
    void set_reg(unsigned number, std::uint32_t value);
    std::uint32_t cpsr() const;
    void set_cpsr(std::uint32_t value);  // banks r13 and r14 with the mode
    std::uint32_t spsr() const;
    void set_spsr(std::uint32_t value);
    std::uint64_t vfp(unsigned number) const;  // d0 - d31
    void set_vfp(unsigned number, std::uint64_t value);
    std::uint32_t fpscr() const;
    void set_fpscr(std::uint32_t value);
    std::uint32_t cp15(const Cp15& name) const;
    void set_cp15(const Cp15& name, std::uint32_t value);

    // RAM by physical address; false where there is none.
    bool read_ram(std::uint32_t address, void* data, std::size_t bytes) const;
    // Also drops what was translated from there: for whoever writes instructions.
    bool write_ram(std::uint32_t address, const void* data, std::size_t bytes);
    void forget_translations(std::uint32_t address, std::size_t bytes);

private:
    struct Hooks;
    struct Engine;

    void abort(void* uc, std::uint32_t address, bool write);
    unsigned hint() const;

    std::unique_ptr<Engine> engine_;
    ArmBus& bus_;
    ArmProbe* probe_ = nullptr;
    ArmWatch* watch_ = nullptr;
    std::uint64_t count_ = 0, limit_ = 0;
    std::uint32_t last_pc_ = 0;
    int exception_ = 0;  // number that Unicorn gave, or 0
    bool aborted_ = false;
    bool watched_ = false;  // the access in progress is not to be done
    ArmFault fault_;
};

}  // namespace sim
