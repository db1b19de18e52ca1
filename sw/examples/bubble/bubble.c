// bubble.c - a spirit level on the monitor: one program for the DE10-Lite and for the DE1-SoC
//
// The square lies where the board's tilt sends it.  The DE10-Lite has an accelerometer for that; on
// the DE1-SoC, where the FPGA has none, it stays in the middle.  HEX0 counts presses of KEY1, LEDR
// shows the voltage at the converter's first input.  How large the picture is the controller says:
// 160 x 120 or 320 x 240 pixels.
#include "memory.h"
#include "processor.h"
#include "registers.h"

enum { DATA_X = 0x32, DATA_Y = 0x34 };  // of the ADXL345
enum { KEY1 = 2, SIDE_PARTS = 8, WHITE = 0xFFFF, BLUE = 0x0010 };

// The DE10-Lite Computer's port to its accelerometer.
#define SENSOR_ADDRESS (*(volatile uint8_t*)0xFF204020)
#define SENSOR_VALUE (*(volatile uint8_t*)0xFF204021)

static volatile uint32_t presses;

INTERRUPT_HANDLER on_irq(void) {
    const uint32_t id = interrupt_begin();
    if (id == KEY_INTERRUPT) {
        KEY_EDGE = KEY_EDGE;
        ++presses;
    }
    interrupt_end(id);
}

static int width, height;
static uint32_t pitch;  // bytes from a row to the next

static void fill(uint32_t picture, int left, int top, int columns, int rows, uint16_t colour) {
    for (int y = top; y < top + rows; ++y)
        for (int x = left; x < left + columns; ++x)
            if (x >= 0 && x < width && y >= 0 && y < height)
                *(volatile uint16_t*)(picture + (uint32_t)y * pitch + (uint32_t)x * 2) = colour;
}

static void text(int column, int line, const char* words) {
    volatile char* at = (volatile char*)(CHARACTERS + (line << 7) + column);
    while (*words) *at++ = *words++;
}

// Of the axis whose low byte is that register; 256 is 1 g.
static int acceleration(uint8_t number) {
    SENSOR_ADDRESS = number;
    const unsigned low = SENSOR_VALUE;
    SENSOR_ADDRESS = (uint8_t)(number + 1);
    return (int16_t)(SENSOR_VALUE << 8 | low);
}

static uint32_t show(void) {
    PIXEL_BUFFER = 1;
    while (PIXEL_STATUS & 1) {
    }
    return PIXEL_BACK_BUFFER;
}

int main(void) {
    width = PIXEL_RESOLUTION & 0xFFFF;
    height = PIXEL_RESOLUTION >> 16;
    pitch = 2u << (PIXEL_STATUS >> 16 & 0xFF);
    const int has_sensor = width == 160, side = height / SIDE_PARTS;
    text(1, 1, has_sensor ? "DE10-Lite: 160 x 120" : "DE1-SoC: 320 x 240");

    PIXEL_BACK_BUFFER = PICTURES;
    uint32_t picture = PIXEL_BACK_BUFFER;
    for (int n = 0; n < 2; ++n) {
        fill(picture, 0, 0, width, height, BLUE);
        picture = show();
    }
    KEY_MASK = KEY1;
    interrupt_on(KEY_INTERRUPT);
    interrupts_enable();

    ADC_CH_1 = 1;  // again and again
    int left[2] = {0, 0}, top[2] = {0, 0};
    for (unsigned n = 0;; n ^= 1) {
        const int x = has_sensor ? acceleration(DATA_X) : 0;
        const int y = has_sensor ? acceleration(DATA_Y) : 0;
        fill(picture, left[n], top[n], side, side, BLUE);
        left[n] = (width - side) / 2 + x * width / 1024;
        top[n] = (height - side) / 2 - y * height / 1024;
        fill(picture, left[n], top[n], side, side, WHITE);
        picture = show();
        HEX3_0_DATA = DIGITS[presses % 10];
        LEDR_DATA = (1u << (ADC_CH_0 & 0xFFF) * 11 / 4096) - 1;
    }
}
