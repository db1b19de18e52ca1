// core.h - a RISC-V processor of 32 bits, RV32IMAF with Zicsr and Zifencei in machine mode, as a
// plain interpreter: runs, counts, stops exactly where asked.
//
// No SystemC here, and no time but clocks, by a table (RiscvClocks).  RAM belongs to the caller and
// is shared; all other addresses go to a RiscvBus, one call per access.  run() returns between two
// instructions, never within one, with pc() exact.
//
// Traps are not entered here by themselves: run() returns what happened, enter() goes to the
// handler.
//
// Instructions are decoded a page at once.  Code that a program writes is seen after FENCE.I, as by
// a processor with an instruction cache; what write_ram() writes is seen at once.
//
// As Nios V/g by the vendor's manual: an access that is not aligned is a trap; the interrupts are
// 3, 7 and 16 to 31; mtvec may be vectored; a rounding mode other than to nearest is an illegal
// instruction where it is written into frm.
//
// Not handled: debug mode, triggers, ECC, custom instructions, the CLIC, mhpmcounters, and
// mstatus.FS, which is kept but forbids nothing.  cycle, time and instret of user mode are illegal.
// mvendorid, marchid and mimpid read 0: what the vendor's processor has is not documented.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "sim/cpu/riscv/fpu.h"
#include "sim/cpu/riscv/instructions.h"

namespace sim {

// Everything except RAM.  Called in the middle of run(): the core must not be changed except by
// stop_soon(), stop_after() and set_pending().
class RiscvBus {
public:
    // False: no target answers, an access fault.
    virtual bool read(std::uint32_t address, unsigned bytes, std::uint32_t& value) = 0;
    virtual bool write(std::uint32_t address, unsigned bytes, std::uint32_t value) = 0;
    // mcycle, but for what was written there.
    virtual std::uint64_t cycles() = 0;

protected:
    ~RiscvBus() = default;
};

// A debugger: may end run() before an instruction, with LIMIT.
class RiscvProbe {
public:
    // True ends it before the instruction at `pc`.
    virtual bool before(std::uint32_t pc) = 0;
    // Before each access of a load or store; true ends it before that instruction.
    virtual bool touches(std::uint32_t /*address*/, unsigned /*bytes*/, bool /*write*/) {
        return false;
    }

protected:
    ~RiscvProbe() = default;
};

// A profiler.
class RiscvTally {
public:
    // The instruction at `pc` is next, the core as it is before it.
    virtual void executes(std::uint32_t pc) = 0;

protected:
    ~RiscvTally() = default;
};

enum class RiscvStop {
    LIMIT,  // the clocks are over, or stop_soon()
    WFI,    // pc is after it
    TRAP,   // trap(); pc is at the instruction
};

struct RiscvTrap {
    std::uint32_t cause;  // as in mcause
    std::uint32_t value;  // for mtval
};

namespace riscv_cause {
constexpr std::uint32_t FETCH_MISALIGNED = 0, FETCH_FAULT = 1, ILLEGAL = 2, BREAKPOINT = 3,
                        LOAD_MISALIGNED = 4, LOAD_FAULT = 5, STORE_MISALIGNED = 6, STORE_FAULT = 7,
                        ECALL = 11, INTERRUPT = 0x80000000;
}

namespace riscv_mstatus {
constexpr std::uint32_t MIE = 1u << 3, MPIE = 1u << 7, MPP = 3u << 11, FS = 3u << 13, SD = 1u << 31;
}

namespace riscv_csr {
constexpr std::uint32_t FFLAGS = 0x001, FRM = 0x002, FCSR = 0x003, MSTATUS = 0x300, MISA = 0x301,
                        MIE = 0x304, MTVEC = 0x305, MSCRATCH = 0x340, MEPC = 0x341, MCAUSE = 0x342,
                        MTVAL = 0x343, MIP = 0x344, MCYCLE = 0xB00, MINSTRET = 0xB02,
                        MCYCLEH = 0xB80, MINSTRETH = 0xB82, MVENDORID = 0xF11, MARCHID = 0xF12,
                        MIMPID = 0xF13, MHARTID = 0xF14;
}

class RiscvCore {
public:
    explicit RiscvCore(RiscvBus& bus, RiscvFpu::Style style = RiscvFpu::Style::IEEE,
                       const RiscvClocks& clocks = {});

    // In multiples of 4096 bytes.  The first that is mapped is the fastest.  `data_by_bus`: loads
    // and stores use the bus, instructions are still read from the RAM.
    void map_ram(std::uint32_t base, std::uint32_t size, std::uint8_t* bytes,
                 bool data_by_bus = false);
    // RAM; false where there is none.
    bool read_ram(std::uint32_t address, void* data, std::size_t bytes) const;
    bool write_ram(std::uint32_t address, const void* data, std::size_t bytes);

    // Registers are 0 but for pc.
    void reset(std::uint32_t entry);

    // Runs for so many clocks, of which the last instruction may take more.
    RiscvStop run(std::uint64_t clocks);
    // One instruction, without asking the probe for one at pc.
    RiscvStop step();
    // From the bus: run() ends after the present instruction, or when so many clocks are over
    // after it.
    void stop_soon() { end_ = 0; }
    void stop_after(std::uint64_t clocks) { end_ = at_ + clocks; }
    const RiscvTrap& trap() const { return trap_; }
    // Where the handler of this trap is; goes there.
    std::uint32_t handler(const RiscvTrap& trap) const;
    void enter(const RiscvTrap& trap);

    // The interrupts' lines, as bits of mip.
    void set_pending(std::uint32_t lines);
    // The interrupt that is taken next, as a trap, if one is pending, enabled and not masked.
    std::optional<RiscvTrap> pending_interrupt() const;
    bool is_pending() const { return mip_ & mie_; }  // ends a WFI, masked or not

    // Since the beginning; from the bus: before the present instruction.
    std::uint64_t clocks() const { return at_; }
    std::uint64_t instructions() const { return instructions_; }
    std::uint64_t traps() const { return traps_; }      // how many were entered
    std::uint64_t returns() const { return returns_; }  // how many MRET
    // The program has spent so many clocks without the core.
    void pass(std::uint64_t clocks) { at_ += clocks; }

    std::uint32_t pc() const { return pc_; }
    void set_pc(std::uint32_t pc) { pc_ = pc; }
    std::uint32_t reg(unsigned number) const { return x_[number]; }
    void set_reg(unsigned number, std::uint32_t value) {
        if (number) x_[number] = value;
    }
    std::uint32_t float_reg(unsigned number) const { return f_[number]; }
    void set_float_reg(unsigned number, std::uint32_t value) { f_[number] = value; }
    // As CSRR and CSRW; nothing, false: it is not there, or not to be written.
    std::optional<std::uint32_t> csr(std::uint32_t number) const;
    bool set_csr(std::uint32_t number, std::uint32_t value);
    bool has_set_mtvec() const { return mtvec_set_; }

    // Each sees every instruction; nullptr takes it away.  Costs half the speed.  Not in run().
    void attach(RiscvProbe* probe) { probe_ = probe; }
    void attach(RiscvTally* tally) { tally_ = tally; }

private:
    struct Ram {
        std::uint32_t base = 0, size = 0;
        std::uint8_t* bytes = nullptr;
        bool data_by_bus = false;
    };

    const Ram* ram_at(std::uint32_t address, std::size_t bytes) const;
    std::uint8_t* data_at(std::uint32_t address, unsigned bytes) const;
    RiscvPage* fetch(std::uint32_t pc);
    RiscvPage* page_at(std::uint32_t pc) {
        RiscvPage* page = pages_[pc / RiscvPage::BYTES].get();
        return page && page->checked == generation_ ? page : fetch(pc);
    }
    template <bool CLOSELY>
    RiscvStop execute(std::uint64_t most);
    bool load(std::uint32_t address, unsigned bytes, std::uint32_t& value);
    bool store(std::uint32_t address, unsigned bytes, std::uint32_t value);
    bool atomic(const RiscvOp& op);
    bool floating(const RiscvOp& op);
    bool change_csr(std::uint32_t word);
    bool write_floating(std::uint32_t number, std::uint32_t value);
    bool raise(std::uint32_t cause, std::uint32_t value) {
        trap_ = {cause, value};
        return false;
    }

    RiscvBus& bus_;
    const RiscvClocks clocks_;
    const bool nearest_alone_;  // frm takes no other mode
    std::vector<Ram> ram_;
    std::vector<std::unique_ptr<RiscvPage>> pages_;
    std::uint64_t generation_ = 1;

    std::array<std::uint32_t, 33> x_{};  // the last is RiscvOp::NOWHERE
    std::array<std::uint32_t, 32> f_{};
    std::uint32_t pc_ = 0;
    RiscvFpu fpu_;
    unsigned frm_ = 0;
    std::uint32_t mstatus_ = 0, mie_ = 0, mip_ = 0, mtvec_ = 0, mscratch_ = 0, mepc_ = 0,
                  mcause_ = 0, mtval_ = 0;
    std::uint64_t cycles_written_ = 0,
                  instructions_written_ = 0;  // differences to what was counted
    bool mtvec_set_ = false;
    std::optional<std::uint32_t> reserved_;  // by LR

    RiscvProbe* probe_ = nullptr;
    RiscvTally* tally_ = nullptr;
    bool past_probe_ = false;
    bool ended_ = false;  // run(), by the probe or by an interrupt that is no longer masked
    std::uint64_t at_ = 0, end_ = 0;  // clocks
    std::uint64_t instructions_ = 0, traps_ = 0, returns_ = 0;
    RiscvTrap trap_{0, 0};
};

}  // namespace sim
