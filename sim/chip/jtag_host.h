// jtag_host.h - a PC on the USB-Blaster with a nios2-terminal for each of the two JTAG UARTs.
//
// It polls both every millisecond, a frame of full-speed USB.  In that millisecond it takes up to
// 64 bytes of each as they come, a packet of the cable's FT245.  It sends the next typed byte to
// the first JTAG UART if there is room; to one without a byte it signals that the host has looked
// (idle_i).  So each sends 64 kB/s at most and receives 1 kB/s, and AC is set a millisecond after
// power-on.
//
// Not handled: the JTAG chain below; cables that are faster or slower; typing to the second.
#pragma once

#include <deque>
#include <functional>
#include <string>

#include "sim/fpga/fpga.h"

#include <systemc>

namespace sim {

class JtagHost : public sc_core::sc_module {
public:
    // `shown` gets each character that a JTAG UART sends.
    JtagHost(const sc_core::sc_module_name& name, Fpga& fpga, std::function<void(char)> shown);

    void type(const std::string& text) { typed_.insert(typed_.end(), text.begin(), text.end()); }

private:
    static constexpr unsigned UARTS = 2, PACKET = 64;

    void look();
    void byte(unsigned number, char character, JtagInputs& jtag);

    Fpga& fpga_;
    std::function<void(char)> shown_;
    sc_core::sc_event look_;
    std::deque<char> typed_;
    unsigned taken_[UARTS] = {};  // since the last look
};

}  // namespace sim
