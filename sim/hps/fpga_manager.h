// fpga_manager.h - the HPS's FPGA manager: the FPGA is configured, and stays so.
//
//   +0x000 stat: bits 2-0 the mode (1 reset, 2 configuration, 4 user mode), bits 7-3 MSEL, 01010
//   +0x004 ctrl: bit 0 en: the bits below count; bit 2 nconfigpull: reset; bits 7-6 cdratio, bit 9
//   cfgwdth; as a boot loader leaves it that has loaded an .rbf of 32 bits for this MSEL
//   +0x010 gpo, +0x014 gpi: the general purpose signals, to the FPGA and from it
//   +0x850 gpio_ext_porta: the configuration's pins, and that the FPGA has power
//
// A program that pulls nCONFIG sees the modes that come next.  The design stays in the FPGA and
// answers on: `notify` gets that line once.  A bitstream is not loaded: the data port is absent.
//
// Source: Cyclone V HPS TRM, chapter FPGA Manager.
//
// Not handled: loading a bitstream; the configuration's interrupt; that a bridge to an FPGA in
// reset hangs.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <utility>

#include "sim/hps/registers.h"

namespace sim {

class FpgaManager : public Registers {
public:
    struct Wires {
        std::function<void(const std::string&)> notify;
        std::function<void(std::uint32_t gpo, const sc_core::sc_time& now)> gpo;
        std::function<std::uint32_t(const sc_core::sc_time& now)> gpi;
    };
    FpgaManager(const sc_core::sc_module_name& module_name, Wires wires)
        : Registers{module_name}, wires_{std::move(wires)} {}

private:
    static constexpr std::uint32_t STAT = 0x000, CTRL = 0x004, GPO = 0x010, GPI = 0x014,
                                   GPIO_EXT_PORTA = 0x850;
    static constexpr std::uint32_t EN = 1, NCONFIGPULL = 1 << 2, CDRATIO_X8 = 3 << 6,
                                   CFGWDTH_32 = 1 << 9;
    enum Mode : std::uint32_t { RESET = 1, CONFIGURATION = 2, USER = 4 };

    std::uint32_t read(std::uint32_t offset, const sc_core::sc_time& now) override {
        constexpr std::uint32_t MSEL = 0x0A;
        if (offset == STAT) return MSEL << 3 | mode_;
        if (offset == GPIO_EXT_PORTA) return pins();
        if (offset == GPI) return wires_.gpi(now);
        const auto found = values_.find(offset);
        return found == values_.end() ? 0 : found->second;
    }

    void write(std::uint32_t offset, std::uint32_t value, const sc_core::sc_time& now) override {
        values_[offset] = value;
        if (offset == GPO) wires_.gpo(value, now);
        if (offset != CTRL) return;
        if ((value & EN) && (value & NCONFIGPULL)) {
            mode_ = RESET;
            wires_.notify(
                "the program resets the FPGA to load another design (FPGA manager, ctrl): on the "
                "board the design is gone; here it stays, and no bitstream is loaded");
        } else if (mode_ == RESET) {
            mode_ = CONFIGURATION;
        }
    }

    // nSTATUS, CONF_DONE and INIT_DONE, each with the level of its pin; nCONFIG; the power.
    std::uint32_t pins() const {
        constexpr std::uint32_t NSTATUS = 0x201, CONF_DONE = 0x402, INIT_DONE = 0x1004,
                                NCONFIG = 0x100, POWER = 0x800;
        switch (mode_) {
            case RESET: return POWER;
            case CONFIGURATION: return POWER | NCONFIG | NSTATUS;
            case USER: break;
        }
        return POWER | NCONFIG | NSTATUS | CONF_DONE | INIT_DONE;
    }

    Wires wires_;
    Mode mode_ = USER;
    std::map<std::uint32_t, std::uint32_t> values_{{CTRL, CDRATIO_X8 | CFGWDTH_32}};
};

}  // namespace sim
