// jtag_host.h - a PC on the USB-Blaster with a nios2-terminal for each of the two JTAG UARTs.
//
// Every millisecond, a frame of full-speed USB, it looks at both: from then on it takes up to 64
// bytes of each, a packet of the cable's FT245, as they come; it sends the next byte of what was
// typed to the first, if there is room; to the others it tells that it has looked.
// So 64 kB/s come out, 1 kB/s goes in, and AC is set a millisecond after power-on.
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
