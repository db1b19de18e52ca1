// jtag_host.h - a PC on the USB-Blaster with a nios2-terminal for each of the two JTAG UARTs.
//
// It polls both every millisecond, a frame of full-speed USB.  In that millisecond it takes up to
// 64 bytes of each as they come, a packet of the cable's FT245.  It sends each the next byte that
// was typed to it if there is room; to one without a byte it signals that the host has looked
// (idle_i).  So each sends 64 kB/s at most and receives 1 kB/s, and AC is set a millisecond after
// power-on.
//
// Not handled: the JTAG chain below; cables that are faster or slower.
#pragma once

#include <deque>
#include <functional>
#include <string>

#include "sim/chip/fpga_chip.h"
#include "sim/fpga/fabric.h"

#include <systemc>

namespace sim {

class JtagHost : public sc_core::sc_module {
public:
    // `shown` gets each character that a JTAG UART sends, with its number.
    using Shown = std::function<void(unsigned number, char character)>;
    JtagHost(const sc_core::sc_module_name& name, FpgaChip& fpga, Fabric& fabric, Shown shown);

    void type(unsigned number, const std::string& text) {
        typed_[number].insert(typed_[number].end(), text.begin(), text.end());
    }

    // It takes nothing from one of them before it looks again, so that something may wait there.
    bool rests();

private:
    static constexpr unsigned UARTS = 2, PACKET = 64;

    void look();
    void byte(unsigned number, char character, JtagInputs& jtag);

    JtagInputs& inputs();  // as of now

    FpgaChip& fpga_;
    Fabric& fabric_;
    Shown shown_;
    sc_core::sc_event look_;
    std::deque<char> typed_[UARTS];
    unsigned taken_[UARTS] = {};  // since the last look
};

}  // namespace sim
