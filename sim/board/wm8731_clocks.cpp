#include "sim/board/wm8731_clocks.h"

namespace sim {

namespace {

constexpr unsigned USB = 1u << 0, BOSR = 1u << 1, CLKIDIV2 = 1u << 6;  // R8; SR3-SR0 are 5:2

// A frame in halves of one at the base rate of 48 or 44.1 kHz.
struct Halves {
    unsigned adc, dac;
};

// 8 kHz is a sixth of 48 kHz; 8.018 kHz is 2/11 of 44.1 kHz.
Halves halves_of(unsigned sr) {
    const unsigned eight = sr & 8 ? 11 : 12;
    switch (sr & 7) {
        case 0: return {2, 2};
        case 1: return {2, eight};
        case 2: return {eight, 2};
        case 3: return {eight, eight};
        case 6: return sr & 8 ? Halves{0, 0} : Halves{3, 3};
        case 7: return {1, 1};
        default: return {0, 0};
    }
}

}  // namespace

Wm8731Rates wm8731_rates(unsigned r8) {
    const bool usb = (r8 & USB) != 0, bosr = (r8 & BOSR) != 0;
    const unsigned sr = r8 >> 2 & 15;
    Halves halves = halves_of(sr);
    // In USB mode a base of 272 is that of 44.1 kHz, and one of 250 that of 48 kHz.
    const bool listed = halves.dac != 0 && (!usb || bosr == (sr >= 8));
    if (!listed) halves = {2, 2};
    const unsigned base = usb ? bosr ? 272 : 250 : bosr ? 384 : 256;  // core clocks of a frame
    const unsigned clocks = usb ? 1 : base / 64;                      // of a BCLK
    return {r8 & CLKIDIV2 ? 2 * clocks : clocks, base * halves.dac / 2 / clocks,
            base * halves.adc / 2 / clocks, listed};
}

void Wm8731Clocks::edge(bool inverted) {
    bclk_ = !bclk_;
    if (bclk_ != inverted) return;
    dac_.bit_ends(rates_.dac_bclks);
    adc_.bit_ends(rates_.adc_bclks);
}

void Wm8731Clocks::Lrck::bit_ends(unsigned frame) {
    if (++bclks < (level ? frame / 2 : frame - frame / 2)) return;
    bclks = 0;
    level = !level;
}

}  // namespace sim
