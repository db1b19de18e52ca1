#include "sim/chip/jtag_host.h"

namespace sim {

namespace {

const sc_core::sc_time usb_frame{1, sc_core::SC_MS};

}  // namespace

JtagHost::JtagHost(const sc_core::sc_module_name& name, Fpga& fpga, Shown shown)
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
    shown_(number, character);
    if (++taken_[number] == PACKET)
        jtag.take = static_cast<std::uint8_t>(jtag.take & ~(1u << number));
}

bool JtagHost::rests() { return fpga_.jtag().take != (1u << UARTS) - 1; }

void JtagHost::look() {
    JtagInputs& jtag = fpga_.jtag();
    for (unsigned& taken : taken_) taken = 0;
    jtag.take = (1u << UARTS) - 1;
    jtag.idle = jtag.take;
    for (unsigned n = 0; n < UARTS; ++n) {
        if (typed_[n].empty() || !(fpga_.fabric().jtag_room() >> n & 1)) continue;
        const auto byte = static_cast<std::uint8_t>(typed_[n].front());
        typed_[n].pop_front();
        jtag.typed = static_cast<std::uint8_t>(jtag.typed | 1u << n);
        jtag.bytes = static_cast<std::uint16_t>((jtag.bytes & ~(0xFFu << 8 * n)) | byte << 8 * n);
        jtag.idle = static_cast<std::uint8_t>(jtag.idle & ~(1u << n));
    }
    look_.notify(usb_frame);
}

}  // namespace sim
