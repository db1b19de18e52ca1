// adc_meter.c - a voltmeter: SW2-0 choose the channel, HEX3-0 show its millivolts.
//
// With SW9 up the converter runs continuously, and bit 15 of a value says that it is new.  Otherwise
// the program starts each conversion, and the read itself waits for its end; bit 15 is 0 then.
// LEDR counts the new values.
#include "processor.h"
#include "registers.h"

static void show(uint32_t millivolts) {
    uint32_t digits = 0;
    for (int n = 0; n < 4; ++n, millivolts /= 10)
        digits |= (uint32_t)DIGITS[millivolts % 10] << 8 * n;
    HEX3_0_DATA = digits;
}

int main(void) {
    uint32_t count = 0;
    for (;;) {
        const uint32_t channel = SW_DATA & 7, automatic = SW_DATA >> 9 & 1;
        ADC_CH_1 = automatic;
        if (!automatic) ADC_CH_0 = 1;
        uint32_t value;
        do value = (&ADC_CH_0)[channel];
        while (automatic && (value & 0x8000) == 0);
        show(value & 0xFFF);
        LEDR_DATA = ++count;
    }
}
