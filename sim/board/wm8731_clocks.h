// wm8731_clocks.h - the clocks of a WM8731 that is bus master: BCLK and both LRCKs, from XCK by R8
//
// BCLK is 64 times the base rate: a quarter of the core clock, or a sixth with BOSR.  In USB mode
// it is the core clock.  An LRCK moves when BCLK ends a bit, and is high for half of its frame; of
// an odd number of BCLKs, for the smaller half.  With CLKIDIV2 the core clock is half of XCK.
//
// Source: Wolfson's WM8731 datasheet, rev. 4.9: digital audio interfaces, sampling rates.
#pragma once

namespace sim {

struct Wm8731Rates {
    unsigned xcks;                  // of a BCLK
    unsigned dac_bclks, adc_bclks;  // of a frame
    bool listed;                    // in the datasheet's tables; else both are at the base rate
};

Wm8731Rates wm8731_rates(unsigned r8);

class Wm8731Clocks {
public:
    void rates(const Wm8731Rates& rates) { rates_ = rates; }

    // BCLK moves.  `inverted`: it ends a bit by rising.
    void edge(bool inverted);

    bool bclk() const { return bclk_; }
    bool daclrck() const { return dac_.level; }
    bool adclrck() const { return adc_.level; }

private:
    struct Lrck {
        bool level = false;
        unsigned bclks = 0;  // at this level

        void bit_ends(unsigned frame);
    };

    Wm8731Rates rates_ = wm8731_rates(0);
    bool bclk_ = false;
    Lrck dac_, adc_;
};

}  // namespace sim
