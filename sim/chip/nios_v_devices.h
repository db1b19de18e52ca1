// nios_v_devices.h - what Nios V has of its own among the FPGA's registers: the window to them, and
// the machine timer with the software interrupt
//
//   bus --> NiosVWindow --+--> FpgaBridges lw
//                         +--> MachineTimer, 0xFF202100
//
// The registers of the screen's controllers and of video-in hold addresses.  The fabric has an
// address translation before them, as the ARM's system has: their bits 31:30 read as ones.  Nios
// V's system has none, so here they read as zeros, and 0x08000000 is the on-chip memory.
//
//   MachineTimer   +0x00 mtime, +0x04 high   +0x08 mtimecmp, +0x0C high   +0x10 msip, bit 0
//
// mtime counts at 100 MHz from power-on; interrupt 7 is up while mtime >= mtimecmp, interrupt 3
// while msip is 1.  mtimecmp is all ones after a reset, which the vendor's manual leaves open.
//
// Not handled: accesses of the timer other than aligned words are merged with what it holds.
#pragma once

#include <cstdint>
#include <functional>

#include "sim/hps/alarm.h"
#include "sim/hps/registers.h"

#include <systemc>
#include <tlm>
#include <tlm_utils/simple_initiator_socket.h>
#include <tlm_utils/simple_target_socket.h>

namespace sim {

class MachineTimer : public Registers {
public:
    static constexpr unsigned SOFTWARE = 3, TIMER = 7;  // bits of mip
    static constexpr std::uint32_t SIZE = 0x20;

    // `lines` is called with both bits whenever one has changed.
    MachineTimer(const sc_core::sc_module_name& module_name,
                 std::function<void(std::uint32_t)> lines);

private:
    std::uint32_t read(std::uint32_t offset, const sc_core::sc_time& now) override;
    void write(std::uint32_t offset, std::uint32_t value, const sc_core::sc_time& now) override;
    bool allows_bytes() const override { return true; }
    std::uint64_t count(std::uint64_t now_ps) const;
    void update(std::uint64_t now_ps);

    std::uint64_t compare_ = ~std::uint64_t{0}, written_ = 0;  // difference to what was counted
    bool software_ = false;
    std::uint32_t levels_ = 0;
    std::function<void(std::uint32_t)> lines_;
    Alarm alarm_;
};

class NiosVWindow : public sc_core::sc_module {
public:
    tlm_utils::simple_target_socket<NiosVWindow> socket;
    tlm_utils::simple_initiator_socket<NiosVWindow> fpga, timer;

    explicit NiosVWindow(const sc_core::sc_module_name& module_name);

private:
    void transport(tlm::tlm_generic_payload& tx, sc_core::sc_time& delay);
};

}  // namespace sim
