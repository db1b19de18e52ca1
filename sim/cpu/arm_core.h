// arm_core.h - the Cortex-A9's instructions: runs, counts, stops exactly where asked.
//
// No SystemC here, and no time.  RAM belongs to the caller and is shared; all other addresses go to
// an ArmBus, one call per aligned access of 1, 2 or 4 bytes (longer ones are split, the low address
// first).  run() returns between two instructions, never within one, with `pc` exact.
//
// Exceptions are not entered here: run() returns what happened, arm_exceptions.h enters the vector.
//
// Two engines implement this header.  dynarmic (sim/cpu/dynarmic) translates the program to the
// host's instructions: about 1 ns per instruction, 0.1 us per bus access besides what the bus
// takes, 10 us for each new basic block.  Unicorn (sim/cpu/unicorn) replaces it if dynarmic is
// missing: 20 to 50 ns per instruction.  Both count and stop alike, with one exception.  With
// dynarmic, the first bus access of an instruction that has only accessed RAM before can happen at
// too low a count, by less than a basic block; it is the same in every run.
//
// Unaligned loads and stores abort as in ARM DDI 0406C, A3.2.1.  In Normal memory those that may be
// unaligned take 0.1 us; so does each VLD1 to VLD4 and VST1 to VST4 with an :<align> above :64.
//
// Not handled: the second core; caches (instructions that maintain them do nothing); SMC and HVC
// are undefined instructions.  With dynarmic also: FPSCR's cumulative flags of exceptions are not
// exact; code that the translation tables keep from the user mode is translated again after each
// return to that mode.  With Unicorn also: alignment faults, all memory is Strongly-ordered to the
// bus, PMCCNTR reads 0, DFAR of an abort from the translation tables reads 0, clear_exclusive()
// does nothing.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace sim {

// The core's access to everything except RAM.  Called in the middle of run(): registers are those
// before the instruction, and the core must not be changed except by stop_soon().
class ArmBus {
public:
    // False: no target answers.  The instruction then has no effect and run() ends with DATA_ABORT.
    // An access to several words may have done the words before, but its base register is
    // unchanged.
    virtual bool read(std::uint32_t address, unsigned bytes, std::uint32_t& value) = 0;
    virtual bool write(std::uint32_t address, unsigned bytes, std::uint32_t value) = 0;
    // A store to what the translation tables call Normal memory: it may be joined with the next.
    virtual bool write_normal(std::uint32_t address, unsigned bytes, std::uint32_t value) {
        return write(address, bytes, value);
    }
    // Whether the target has done the last write as an exclusive one (STREX), else that fails.
    virtual bool exclusive_stored() { return true; }
    // At a WFI: true if there is nothing to wait for, so that run() goes on.  (Unicorn's core calls
    // neither this nor unmasked().)
    virtual bool passes_wfi() { return false; }
    // An instruction clears CPSR.A, I or F.
    virtual void unmasked() {}

protected:
    ~ArmBus() = default;
};

// A debugger's breakpoints.
class ArmProbe {
public:
    // Before the instruction at `pc`; true ends run() before it, with LIMIT.
    virtual bool before(std::uint32_t pc) = 0;

protected:
    ~ArmProbe() = default;
};

// A profiler's counts.
class ArmTally {
public:
    struct Run {
        std::uint32_t begin;         // of the first instruction
        std::uint64_t instructions;  // all in its function
        std::uint32_t link;          // r14 before the first
        // If the last was a BL or BLX: the address after it, now in r14.  Otherwise not that.
        std::uint32_t end;
    };
    virtual void ran(const Run& run) = 0;
    // Asked once for each piece of code, when it is first executed.
    virtual bool same_function(std::uint32_t pc, std::uint32_t other) const = 0;

protected:
    ~ArmTally() = default;
};

// A debugger's watchpoints.
class ArmWatch {
public:
    // Called within the load or store, once per access; true ends run() with LIMIT and pc at it.
    // Its effects on registers and on the bus are then undone.  A store to RAM is not undone, nor
    // are the registers that a load of several has loaded before.
    virtual bool touched(std::uint32_t address, unsigned bytes, bool write) = 0;

protected:
    ~ArmWatch() = default;
};

enum class ArmStop {
    LIMIT,           // all instructions done, or stop_soon()
    WFI,             // pc is after it
    WFE,             // pc is after it
    SVC,             // pc is after it
    UNDEFINED,       // pc is at it
    BREAKPOINT,      // BKPT; pc is at it
    PREFETCH_ABORT,  // pc is where no instruction can be read from
    DATA_ABORT,      // pc is at the load or store
    RAN_OFF,         // pc is where memory holds nothing but zeros: the program has left its code
};

struct ArmFault {
    std::uint32_t address = 0;  // virtual: of the data, or where an instruction is missing
    bool write = false;
    bool mmu = false;  // by the translation tables, or nothing is mapped
    // Of an abort by the translation tables: fault status as in DFSR and IFSR, without DFSR.WnR.
    std::uint32_t status = 0x5;
    // Of an unaligned access, status 0x1: the address should have been a multiple of this;
    // `always`: whatever the memory's type and SCTLR.A.
    std::uint32_t multiple_of = 1;
    bool always = false;
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

// What a thread has of the core's registers while another thread runs.
struct ArmRegisters {
    std::array<std::uint32_t, 16> r{};
    std::uint32_t cpsr = 0, fpscr = 0;
    std::array<std::uint64_t, 32> vfp{};  // d0 - d31
};

// What programs may do with memory.
namespace arm_access {
constexpr unsigned READ = 1, WRITE = 2, EXECUTE = 4, ALL = 7;
// Normal memory although the MMU is off: an operating system that is emulated has its tables.
constexpr unsigned NORMAL = 8;
}  // namespace arm_access

// A register of coprocessor 15: MRC p15, op1, Rt, CRn, CRm, op2.
struct Cp15 {
    unsigned crn, op1, crm, op2;
};

namespace cp15 {
constexpr Cp15 SCTLR{1, 0, 0, 0}, CPACR{1, 0, 0, 2}, SCR{1, 0, 1, 0}, TTBR0{2, 0, 0, 0},
    TTBR1{2, 0, 0, 1}, TTBCR{2, 0, 0, 2}, DACR{3, 0, 0, 0}, DFSR{5, 0, 0, 0}, IFSR{5, 0, 0, 1},
    DFAR{6, 0, 0, 0}, IFAR{6, 0, 0, 2}, PAR{7, 0, 4, 0}, VBAR{12, 0, 0, 0}, CONTEXTIDR{13, 0, 0, 1},
    TPIDRURW{13, 0, 0, 2}, TPIDRURO{13, 0, 0, 3}, TPIDRPRW{13, 0, 0, 4}, CBAR{15, 4, 0, 0};
}

class ArmCore {
public:
    explicit ArmCore(ArmBus& bus);
    ~ArmCore();

    // All in multiples of 4096 bytes, and not in run().  `bus_base` is the bus's address of `base`.
    // Only what one call has mapped can be unmapped.  `access` is a sum of arm_access.
    // `data_by_bus`: loads and stores use the bus, at the address `base`; instructions are still
    // read from the RAM.  (Unicorn's core ignores it: there loads and stores use the RAM, too.)
    void map_ram(std::uint32_t base, std::uint64_t size, void* bytes,
                 unsigned access = arm_access::ALL, bool data_by_bus = false);
    void map_bus(std::uint32_t base, std::uint64_t size, std::uint32_t bus_base,
                 unsigned access = arm_access::READ | arm_access::WRITE);
    void unmap(std::uint32_t base, std::uint64_t size);
    // No instruction is read from these virtual addresses from now on: PREFETCH_ABORT there.
    void forbid_code(std::uint32_t base, std::uint32_t size);
    // It is again; the same arguments.
    void permit_code(std::uint32_t base, std::uint32_t size);
    // The bus's address of `address`, if that is mapped to the bus.
    std::optional<std::uint32_t> bus_address(std::uint32_t address) const;

    // Asked at these addresses; nullptr takes it away.  Costs nothing elsewhere.  Not in run().
    void attach(ArmProbe* probe, const std::vector<std::uint32_t>& at = {});
    // Sees all instructions; nullptr takes it away.  Costs 0.1 us per change of function.  Not in
    // run().
    void attach(ArmTally* tally);
    // Sees every load and store; nullptr takes it away.  Not in run().
    void watch(ArmWatch* watch);

    // SVC mode, interrupts off, VFP and NEON off, MMU and caches off; `entry` bit 0 is Thumb.
    void reset(std::uint32_t entry, std::uint32_t stack);

    // Runs at most `limit` instructions.
    ArmStop run(std::uint64_t limit);
    // One load or store at whatever address, a byte at a time, as an operating system does it after
    // the fault.
    ArmStop run_by_bytes();
    // Whether the core calls ArmBus::passes_wfi() and unmasked().
    static const bool TELLS_OF_MASKS;
    // From the bus: run() ends before the next instruction.
    void stop_soon() { limit_ = count_; }
    // From the bus: run() ends when `left` more instructions are done after the present one.
    void stop_after(std::uint64_t left) { limit_ = count_ + left; }

    std::uint64_t instructions() const { return count_; }  // since the beginning
    const ArmFault& fault() const { return fault_; }       // of the last abort
    // The address of the instruction that is using the bus, if one is.
    std::uint32_t instruction() const { return last_pc_; }
    // Of the load or store that is using the bus.
    struct OnBus {
        unsigned words;   // that it transfers at rising addresses, where each is a call of its own
        unsigned cache;   // the memory's type, as the Cortex-A9's AxCACHE has it
        bool privileged;  // the mode
        bool exclusive;   // LDREX, STREX
    };
    OnBus on_bus() const;

    std::uint32_t pc() const { return reg(15); }
    std::uint32_t reg(unsigned number) const;  // r0 - r15 of the present mode
    void set_reg(unsigned number, std::uint32_t value);
    std::uint32_t cpsr() const;
    void set_cpsr(std::uint32_t value);  // banks r13 and r14 with the mode
    std::uint32_t spsr() const;
    void set_spsr(std::uint32_t value);
    std::uint64_t vfp(unsigned number) const;  // d0 - d31
    void set_vfp(unsigned number, std::uint64_t value);
    void clear_exclusive();  // as CLREX
    // CPACR and FPEXC.EN, as an operating system sets them, and whether they let VFP and NEON be
    // used in the present mode.
    void set_floating_point(bool on);
    bool floating_point() const;
    std::uint32_t fpscr() const;
    void set_fpscr(std::uint32_t value);
    std::uint32_t cp15(const Cp15& name) const;
    void set_cp15(const Cp15& name, std::uint32_t value);

    // What the program would reach, in no time, for those who know what it will do (steady_loop.h).
    // Unicorn's core and a core that is watched, probed or tallied never say.
    // An instruction; of Thumb, one of 16 bits is at most 0xFFFF.
    std::optional<std::uint32_t> code_at(std::uint32_t pc, bool thumb);
    // PMCCNTR as the next instruction reads it, and whether it counts; nothing if it may not.
    struct Cycles {
        std::uint32_t now;
        bool counts;
    };
    std::optional<Cycles> cycles() const;
    struct Place {
        std::uint8_t* ram = nullptr;       // the host's byte, up to the next multiple of 4 at least
        std::optional<std::uint32_t> bus;  // its address there, if accesses are not merged
    };
    Place place(std::uint32_t address, bool write);
    // The program has done so many instructions without the core.  Not in run().
    void pass(std::uint64_t instructions) { count_ += instructions; }
    // A store of it, for the same purpose; to RAM that place() has given.
    void store_word(std::uint32_t address, std::uint32_t value);

    // RAM by physical address; false where there is none.
    bool read_ram(std::uint32_t address, void* data, std::size_t bytes) const;
    // Also drops the translation of these bytes, so instructions may be written.
    bool write_ram(std::uint32_t address, const void* data, std::size_t bytes);
    void forget_translations(std::uint32_t address, std::size_t bytes);

private:
    struct Engine;

    std::unique_ptr<Engine> engine_;
    std::uint64_t count_ = 0, limit_ = 0;
    std::uint32_t last_pc_ = 0;
    ArmFault fault_;
};

}  // namespace sim
