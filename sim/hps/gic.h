// gic.h - the Cortex-A9's interrupt controller (GICv1): 256 IDs, 32 priorities, one processor.
//
//   distributor   0xFFFED000: ICDDCR ICDICTR ICDIIDR ICDISR ICDISER ICDICER ICDISPR ICDICPR ICDABR
//                             ICDIPR ICDIPTR ICDICFR ICDSGIR
//   CPU interface 0xFFFEC100: ICCICR ICCPMR ICCBPR ICCIAR ICCEOIR ICCRPR ICCHPIR ICCIIDR
//
// IDs 0-15 are software's own (ICDSGIR), 27 global timer, 28 nFIQ, 29 private timer, 30 watchdog,
// 31 nIRQ, 32-255 the HPS and, from 72 on, the FPGA.  A level interrupt is pending while its line
// is up; an edge one from the line's rise to its acknowledge.  IDs from 32 on reach the processor
// only if ICDIPTR names it, which it does not after reset.  ICCIAR reads 1023 if no interrupt can
// be taken.
//
// The processor is in the Secure state, as after reset: ICDISR 0 makes an interrupt Secure,
// signalled as IRQ or, with ICCICR.FIQEn, as FIQ.
//
// Source: ARM IHI 0048A (GIC architecture 1.0), ARM DDI 0407G (Cortex-A9 MPCore, chapter 3).
//
// Not handled: the second processor (interrupts sent only to it are dropped); lockdown.
#pragma once

#include <array>
#include <bitset>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "sim/hps/registers.h"

namespace sim {

// Which interrupt is to be taken: state and rules, no registers.
class GicState {
public:
    static constexpr unsigned IDS = 256, SPURIOUS = 1023, SPURIOUS_NON_SECURE = 1022;
    static constexpr unsigned IDLE_PRIORITY = 0xFF;
    using Bits = std::bitset<IDS>;

    Bits enabled, non_secure, level, latched, active, edge;
    std::array<std::uint8_t, IDS> priority{}, targets{};
    bool distribute_secure = false, distribute_non_secure = false;
    std::uint32_t control = 0;      // ICCICR
    std::uint8_t mask = 0;          // ICCPMR
    std::uint8_t binary_point = 2;  // ICCBPR

    GicState();

    bool pending(unsigned id) const { return latched[id] || (!edge[id] && level[id]); }
    void set_level(unsigned id, bool up);
    unsigned highest_pending() const;  // SPURIOUS if none can be taken
    unsigned running_priority() const;
    void signals(bool& irq, bool& fiq) const;
    unsigned acknowledge();
    void end(unsigned id);

    // What keeps a pending interrupt from the processor, a clause each in the registers' names.
    std::vector<std::string> obstacles(unsigned id) const;
    // How often it was acknowledged since its line has been up.
    unsigned taken(unsigned id) const { return taken_[id]; }

private:
    bool is_fiq(unsigned id) const;
    unsigned group(unsigned priority_value) const;

    std::vector<unsigned> running_;  // acknowledged, the last at the end
    std::array<unsigned, IDS> taken_{};
};

class Gic;

class GicDistributor : public Registers {
public:
    GicDistributor(const sc_core::sc_module_name& module_name, Gic& gic);

private:
    std::uint32_t read(std::uint32_t offset, const sc_core::sc_time& now) override;
    void write(std::uint32_t offset, std::uint32_t value, const sc_core::sc_time& now) override;
    bool allows_bytes() const override { return true; }
    void send(std::uint32_t value, const sc_core::sc_time& now);

    Gic& gic_;
};

class GicCpuInterface : public Registers {
public:
    GicCpuInterface(const sc_core::sc_module_name& module_name, Gic& gic);

private:
    std::uint32_t read(std::uint32_t offset, const sc_core::sc_time& now) override;
    void write(std::uint32_t offset, std::uint32_t value, const sc_core::sc_time& now) override;

    Gic& gic_;
};

class Gic : public sc_core::sc_module {
public:
    // `signal` is called with the levels of IRQ and FIQ when one of them changes.
    Gic(const sc_core::sc_module_name& name, std::function<void(bool irq, bool fiq)> signal);

    void set_level(unsigned id, bool up);

    const GicState& state() const { return state_; }
    // When its line, or software, last made it pending.
    const sc_core::sc_time& raised_at(unsigned id) const { return raised_at_[id]; }

    GicDistributor distributor;
    GicCpuInterface cpu_interface;

private:
    friend GicDistributor;
    friend GicCpuInterface;

    void update();

    GicState state_;
    std::array<sc_core::sc_time, GicState::IDS> raised_at_;
    std::function<void(bool, bool)> signal_;
    bool irq_ = false, fiq_ = false;
};

}  // namespace sim
