// de10_lite_computer.h - the chip as the DE10-Lite Computer with Nios V: NiosVComputer with another
// map, another picture and other pins
//
//   Bus --> De10LiteMap -+- FpgaBridges h2f: SDRAM, characters   De10LitePins --> pins
//                        +- De10LitePicture: on-chip memory, pixel buffer controller
//                        +- NiosVWindow: what is as on the DE1-SoC
//                        +- ArduinoPort, Max10Converter, AccelerometerPort
//
// The fabric is that of the DE1-SoC's computer, of which this one has a part; its registers are in
// rtl/regmap/DE10_LITE.md.  As Platform Designer's interconnect does it, an access that no block
// takes, and a write to a block that can only be read, goes to the slave with the largest span:
// the SDRAM, of whose 64 MB it has the lower 26 bits.
//
// Source: as rtl/regmap/de10_lite.def and de10_lite_devices.h; Platform Designer User Guide,
// "Accessing Undefined Memory Regions".
//
// Not handled: the debug module at 0x0A000000; addresses from 0x10000000 to 0xFF1FFFFF and from
// 0xFF400000 on, which are refused, where on the board the SDRAM answers.  An access takes as long
// as on the DE1-SoC's computer.  A processor with Nios V/m, which the vendor's script has, too.
#pragma once

#include <functional>
#include <memory>
#include <set>
#include <string>
#include <utility>

#include "sim/chip/de10_lite_devices.h"
#include "sim/chip/de10_lite_picture.h"
#include "sim/chip/de10_lite_pins.h"
#include "sim/chip/nios_v_computer.h"
#include "sim/hps/bridge_windows.h"

namespace sim {

class De10LiteMap : public sc_core::sc_module {
public:
    tlm_utils::simple_target_socket<De10LiteMap> memory, registers;
    tlm_utils::simple_initiator_socket<De10LiteMap> to_memory, to_registers;

    // `log` gets a line where an access goes to the SDRAM in place of a block, once for each place.
    De10LiteMap(const sc_core::sc_module_name& name, FpgaChip& fpga, Fabric& fabric,
                De10LitePins& pins, const std::uint8_t* sdram,
                std::function<void(unsigned line, bool up)> interrupt,
                std::function<void(const std::string&)> log);

    De10LitePicture picture;

private:
    struct Access {
        bool write;
        std::uint32_t address;
        std::uint8_t* data;
        unsigned bytes;
    };
    using Socket = tlm_utils::simple_initiator_socket<De10LiteMap>;

    void transport_memory(tlm::tlm_generic_payload& tx, sc_core::sc_time& delay) {
        transport(0, tx, delay);
    }
    void transport_registers(tlm::tlm_generic_payload& tx, sc_core::sc_time& delay) {
        transport(LW_BASE, tx, delay);
    }
    void transport(std::uint32_t base, tlm::tlm_generic_payload& tx, sc_core::sc_time& delay);
    bool direct_memory(tlm::tlm_generic_payload& tx, tlm::tlm_dmi& dmi);
    tlm::tlm_response_status word(const Access& access, sc_core::sc_time& delay);
    tlm::tlm_response_status elsewhere(const Access& access, sc_core::sc_time& delay);
    tlm::tlm_response_status pixels(const Access& access, sc_core::sc_time& delay);
    tlm::tlm_response_status controller(const Access& access, sc_core::sc_time& delay);
    tlm::tlm_response_status text(const Access& access, sc_core::sc_time& delay);
    tlm::tlm_response_status keys(const Access& access, sc_core::sc_time& delay);
    tlm::tlm_response_status accelerometer(const Access& access, sc_core::sc_time& delay);
    tlm::tlm_response_status own(const Access& access, sc_core::sc_time& delay);
    tlm::tlm_response_status pass(Socket& to, const Access& access, std::uint32_t address,
                                  sc_core::sc_time& delay);
    void come_to(sc_core::sc_time& delay);

    FpgaChip& fpga_;
    Fabric& fabric_;
    De10LitePins& pins_;
    std::function<void(const std::string&)> log_;
    std::set<std::pair<std::uint32_t, bool>> reported_;
    ArduinoPort arduino_;
    bool arduino_runs_ = false;
    Max10Converter converter_;
    AccelerometerPort accelerometer_;
    bool pixels_on_ = true, text_on_ = true;  // EN of both controllers
};

// Built before the fabric, which notifies them.
struct De10LiteBoardSide {
    explicit De10LiteBoardSide(PinListener& board) : lite_pins{board} {}
    De10LitePins lite_pins;
};

class De10LiteComputer : private De10LiteBoardSide, public NiosVComputer {
public:
    De10LiteComputer(const sc_core::sc_module_name& name, PinListener& pins, ChipObserver& observer,
                     std::uint8_t* sdram, NiosVProgram program, const Settings& settings);

    void hps_accelerometer_interrupt(bool up) override;

private:
    bool is_plain(std::uint32_t address, bool write, std::uint32_t value) const override;

    De10LiteMap map_;
};

}  // namespace sim
