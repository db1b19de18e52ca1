// all_pins.c - moves and reads every pin that fpga.v has, so that a wrong wire to it shows.
//
// A sum of all that is read is printed again and again; LINE IN is played; the camera's picture is on
// the screen; LEDR, HEX and JP2 show what comes and goes.
//
// Not handled: PS/2 but for the clocks that the chip pulls low itself, since keyboard and mouse take
// half a second to test themselves.
#include "registers.h"

#define JP2 REGISTER(0xFF200070)
#define JP2_DIRECTION REGISTER(0xFF200074)
#define SECOND_PS2_DATA REGISTER(0xFF200108)
#define SECOND_PS2_CONTROL REGISTER(0xFF20010C)
#define SECOND_JTAG_UART_DATA REGISTER(0xFF201008)
#define SDRAM ((volatile uint32_t*)0xC0000000)

enum { WORDS_LOG2 = 24, FIFOS_EMPTY = 12, AUTOMATIC = 1, CAMERA_ON = 4 };

// A sum in which each bit goes on to count.
static uint32_t with(uint32_t sum, uint32_t word) {
    return (sum << 7 | sum >> 25) * 31 + word;
}

static void sdram(void) {
    for (unsigned bit = 0; bit < WORDS_LOG2; ++bit) SDRAM[1u << bit] = 0x9E3779B9u << bit | bit;
    for (unsigned bit = 2; bit < 8; ++bit) ((volatile uint8_t*)SDRAM)[(1u << bit) + bit % 4] = 0xA0;
    uint32_t sum = 0;
    for (unsigned bit = 0; bit < WORDS_LOG2; ++bit) sum = with(sum, SDRAM[1u << bit]);
    for (unsigned digit = 0; digit < 8; ++digit)
        JTAG_UART0_DATA = (uint32_t)"0123456789ABCDEF"[sum >> 4 * digit & 15];
    JTAG_UART0_DATA = '\n';
}

int main(void) {
    uint32_t sum = 0;
    JP1_DIR = JP2_DIRECTION = 0xFFFFFFFF;
    for (unsigned n = 0; n < 32; ++n) {
        JP1_DATA = 1u << n;
        sum = with(sum, JP1_DATA);
    }
    JP1_DIR = 0;
    VIDEO_IN_STATUS = CAMERA_ON;
    (&ADC_CH_0)[1] = AUTOMATIC;
    AUDIO_CONTROL = FIFOS_EMPTY;
    AUDIO_CONTROL = 0;
    SECOND_JTAG_UART_DATA = '2';
    sdram();
    for (unsigned n = 0;; ++n) {
        const uint32_t read[] = {SW_DATA, KEY_DATA, JP1_DATA, JP2, (&ADC_CH_0)[n % 8], PS2_0_CONTROL, SECOND_PS2_CONTROL,
                                 IRDA_DATA, JTAG_UART0_DATA};
        for (unsigned i = 0; i < sizeof read / sizeof *read; ++i) sum = with(sum, read[i]);
        LEDR_DATA = read[0];
        HEX3_0_DATA = sum;
        HEX5_4_DATA = sum >> 16;
        JP2 = 1u << n % 32;
        if (n % 256 == 0) JTAG_UART0_DATA = 'A' + sum % 26;
        if (n % 1024 == 0) PS2_0_DATA = 0xFF;
        if (n % 1024 == 512) SECOND_PS2_DATA = 0xFF;
        while ((AUDIO_FIFOSPACE & 0xFF) != 0) {
            AUDIO_LEFTDATA = AUDIO_LEFTDATA;
            AUDIO_RIGHTDATA = AUDIO_RIGHTDATA;
        }
    }
}
