// nios_v_debugger.h - GDB at Nios V: its registers and its traps.
//
// Stops by itself: an EBREAK (SIGTRAP), which ends the program where the debugger neither moves pc
// nor puts another instruction there; a trap by which the program fails, as by one that it has no
// handler for (SIGILL, SIGSEGV, SIGBUS, SIGSYS).  While there is a point, each instruction is
// looked at, which takes up to twice as long.
//
// Not handled: virtual registers (priv), triggers that the program sets itself.
#pragma once

#include "sim/cpu/nios_v_cpu.h"
#include "sim/debug/debugger.h"

namespace sim {

class NiosVDebugger final : public Debugger, private NiosVInspector, private RiscvProbe {
public:
    // Attaches itself.
    NiosVDebugger(NiosVCpu& cpu, GdbConnection& connection, std::function<bool()> given_up);
    ~NiosVDebugger() override;

private:
    void on_start() override { begin(); }
    bool on_quantum() override { return quantum_begins(); }
    bool on_breakpoint() override;
    bool on_failure(std::uint32_t cause) override;
    bool holds_interrupts() override { return keeps_interrupts_out(); }
    bool before(std::uint32_t pc) override;
    bool touches(std::uint32_t address, unsigned bytes, bool write) override {
        return accesses_ && touches_point(address, bytes, write);
    }

    const GdbRegisters& registers() const override;
    std::uint64_t reg(unsigned number) override;
    bool set_reg(unsigned number, std::uint64_t value) override;

    std::uint32_t pc() const override { return core_.pc(); }
    std::uint64_t instructions() const override { return core_.instructions(); }
    bool read_ram(std::uint32_t address, void* data, std::size_t bytes) override {
        return core_.read_ram(address, data, bytes);
    }
    bool write_ram(std::uint32_t address, const void* data, std::size_t bytes) override {
        return core_.write_ram(address, data, bytes);
    }
    void observe(const std::vector<std::uint32_t>& breaks, bool accesses) override;

    NiosVCpu& cpu_;
    RiscvCore& core_;
    std::vector<std::uint32_t> breaks_;
    bool accesses_ = false;
};

}  // namespace sim
