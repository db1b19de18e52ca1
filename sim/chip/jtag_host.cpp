#include "sim/chip/jtag_host.h"

namespace sim {

namespace {

const sc_core::sc_time usb_frame{1, sc_core::SC_MS};

}  // namespace

JtagHost::JtagHost(const sc_core::sc_module_name& name, Fpga& fpga, std::function<void(char)> shown)
    : sc_module{name}, fpga_{fpga}, shown_{std::move(shown)} {
    fpga_.on_jtag_byte(
        [this](auto number, char character, auto& in) { byte(number, character, in); });
    SC_HAS_PROCESS(JtagHost);
    SC_METHOD(look);
    sensitive << look_;
    dont_initialize();
    look_.notify(usb_frame);
}

void JtagHost::byte(unsigned number, char character, JtagInputs& jtag) {
    shown_(character);
    if (++taken_[number] == PACKET)
        jtag.take = static_cast<std::uint8_t>(jtag.take & ~(1u << number));
}

void JtagHost::look() {
    JtagInputs& jtag = fpga_.jtag();
    for (unsigned& taken : taken_) taken = 0;
    jtag.take = (1u << UARTS) - 1;
    jtag.idle = jtag.take;
    if (!typed_.empty() && (fpga_.fabric().jtag_room() & 1)) {
        jtag.typed = 1;
        jtag.bytes = static_cast<std::uint8_t>(typed_.front());
        jtag.idle &= 2;
        typed_.pop_front();
    }
    look_.notify(usb_frame);
}

}  // namespace sim
