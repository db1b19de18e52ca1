// leds_and_rectangle.c - LEDs follow the switches; a red rectangle on the screen; says "ready".
#include <stdint.h>

#define REGISTER(address) (*(volatile uint32_t*)(address))
#define LEDR REGISTER(0xFF200000)
#define SW REGISTER(0xFF200040)
#define UART_THR REGISTER(0xFFC02000)

enum { LEFT = 10, RIGHT = 100, TOP = 20, BOTTOM = 60, RED = 0xF800 };

int main(void) {
    for (uint32_t y = TOP; y < BOTTOM; ++y)
        for (uint32_t x = LEFT; x < RIGHT; ++x)
            *(volatile uint16_t*)(0xC8000000 + (y << 10) + (x << 1)) = RED;
    for (const char* c = "ready\n"; *c; ++c) UART_THR = (uint32_t)*c;
    for (;;) LEDR = SW;
}
