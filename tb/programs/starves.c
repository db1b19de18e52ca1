// starves.c - plays twenty samples three times and nothing after each; then fills the left FIFO
// alone, of which nothing is played.
#include "registers.h"

#define UART_THR REGISTER(0xFFC02000)
#define CODEC_UNDERRUNS REGISTER(0xFF205108)

int main(void) {
    for (uint32_t round = 1; round <= 3; ++round) {
        for (int n = 0; n < 20; ++n) AUDIO_LEFTDATA = AUDIO_RIGHTDATA = 0x01000000;
        while (CODEC_UNDERRUNS < round) {}
    }
    for (int n = 0; n < 100; ++n) AUDIO_LEFTDATA = 0x01000000;
    for (const char* text = "held\n"; *text; ++text) UART_THR = (uint32_t)*text;
    return 0;
}
