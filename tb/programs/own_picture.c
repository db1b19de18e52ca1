// own_picture.c - draws into a variable, which lies in the DDR3 memory, and gives it to the pixel
// controller, as programs for simulators do that show any memory.
#include "registers.h"

static volatile uint16_t picture[240][512];

int main(void) {
    PIXEL_BACK_BUFFER = (uint32_t)(uintptr_t)picture;
    for (int y = 0; y < 240; ++y)
        for (int x = 0; x < 320; ++x) picture[y][x] = 0xF800;
    for (;;) {
        PIXEL_BUFFER = 1;
        while (PIXEL_STATUS & 1)
            ;
    }
}
