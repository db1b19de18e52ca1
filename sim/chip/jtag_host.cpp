#include "sim/chip/jtag_host.h"

namespace sim {

namespace {

const sc_core::sc_time usb_frame{1, sc_core::SC_MS};

}  // namespace

JtagHost::JtagHost(const sc_core::sc_module_name& name, FpgaChip& fpga, Fabric& fabric, Shown shown)
    : sc_module{name}, fpga_{fpga}, fabric_{fabric}, shown_{std::move(shown)} {
    fabric_.on_jtag_byte(
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

JtagInputs& JtagHost::inputs() {
    fpga_.run_to(sc_core::sc_time_stamp().value());
    return fabric_.jtag;
}

bool JtagHost::rests() { return inputs().take != (1u << UARTS) - 1; }

void JtagHost::look() {
    JtagInputs& jtag = inputs();
    for (unsigned& taken : taken_) taken = 0;
    jtag.take = (1u << UARTS) - 1;
    jtag.idle = jtag.take;
    for (unsigned n = 0; n < UARTS; ++n) {
        if (typed_[n].empty() || !(fabric_.jtag_room() >> n & 1)) continue;
        const auto byte = static_cast<std::uint8_t>(typed_[n].front());
        typed_[n].pop_front();
        jtag.typed = static_cast<std::uint8_t>(jtag.typed | 1u << n);
        jtag.bytes = static_cast<std::uint16_t>((jtag.bytes & ~(0xFFu << 8 * n)) | byte << 8 * n);
        jtag.idle = static_cast<std::uint8_t>(jtag.idle & ~(1u << n));
    }
    look_.notify(usb_frame);
}

}  // namespace sim
