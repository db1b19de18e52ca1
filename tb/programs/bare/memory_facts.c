// memory_facts.c - facts about the FPGA's memories and about what the screen shows
//
// HEX0 shows what is on the screen: 1 a picture in the SDRAM, 2 the same at its end, 3 nothing
// because the controller is off, 4 two letters in its upper corners.
#include "processor.h"
#include "facts.h"

#define TEXT_BACK REGISTER(0xFF203034)
#define TEXT_STATUS REGISTER(0xFF20303C)
#define HALF(address) (*(volatile uint16_t*)(address))
#define BYTE(address) (*(volatile uint8_t*)(address))

enum { SDRAM = 0xC0000000, ON_CHIP = 0xC8000000, CHARACTERS = 0xC9000000 };
enum { S = 1, EN = 4 };

// Whether each address line and each byte lane exists and is independent of the others.
static int is_memory(uint32_t base, uint32_t size) {
    REGISTER(base) = base;
    for (uint32_t line = 4; line < size; line <<= 1) REGISTER(base + line) = base + line;
    REGISTER(base + size - 4) = base + size - 4;
    for (uint32_t line = 4; line < size; line <<= 1)
        if (REGISTER(base + line) != base + line) return 0;
    if (REGISTER(base) != base || REGISTER(base + size - 4) != base + size - 4) return 0;
    REGISTER(base) = 0x11223344;
    BYTE(base + 1) = 0x55;
    HALF(base + 2) = 0x6677;
    return REGISTER(base) == 0x66775544 && BYTE(base + 3) == 0x66 && HALF(base) == 0x5544;
}

static void memories(void) {
    fact(1, is_memory(SDRAM, 64 << 20));
    fact(2, is_memory(ON_CHIP, 256 << 10));
    fact(3, is_memory(CHARACTERS, 8 << 10));
    fact(4, is_memory(0xFFFF0000, 64 << 10));
    for (uint32_t y = 0; y < 240; ++y) HALF(ON_CHIP + (y << 10) + 640) = (uint16_t)y;
    for (uint32_t y = 0; y < 240; ++y) fact(5, HALF(ON_CHIP + (y << 10) + 640) == y);
}

static void swap(void) {
    PIXEL_BUFFER = 1;
    while (PIXEL_STATUS & S) {
    }
}

static void controller(void) {
    static const uint32_t places[] = {0xC0000000, 0xC1234568, 0xC3FC4000, 0xC8000400, 0xC8000000};
    fact(10, PIXEL_BUFFER == ON_CHIP && PIXEL_BACK_BUFFER == ON_CHIP);
    fact(11, PIXEL_RESOLUTION == 0x00F00140 && PIXEL_STATUS == 0x08090F04);
    for (unsigned i = 0; i < sizeof places / sizeof *places; ++i) {
        const uint32_t before = PIXEL_BUFFER;
        PIXEL_BACK_BUFFER = places[i];
        fact(12, PIXEL_BUFFER == before && PIXEL_BACK_BUFFER == places[i]);
        swap();
        fact(13, PIXEL_BUFFER == places[i] && PIXEL_BACK_BUFFER == before);
    }
    swap();  // at the end of a frame, so the next one is a frame later: 800 x 525 clocks of 25 MHz
    A9_TIMER_LOAD = 0xFFFFFFFF, A9_TIMER_CONTROL = 1;
    swap();
    fact(14, about(0xFFFFFFFF - REGISTER(0xFFFEC604), 16800 * 200, 20 * 200));
    PIXEL_STATUS = 0xFFFFFFFF;
    fact(15, PIXEL_STATUS == 0x08090F04);
    PIXEL_STATUS = 0;
    fact(16, PIXEL_STATUS == (0x08090F04 & ~(uint32_t)EN));
    PIXEL_STATUS = EN;
}

static void draw(uint32_t picture, uint32_t colours) {
    for (uint32_t y = 0; y < 240; ++y)
        for (uint32_t x = 0; x < 320; ++x)
            HALF(picture + (y << 10) + 2 * x) =
                (uint16_t)(colours & ((x / 10) << 11 | (y / 4) << 5 | (x ^ y) >> 3));
}

static void show(uint32_t number) {
    HEX3_0_DATA = DIGITS[number];
    while ((SW_DATA & 1u << number) == 0) {
    }
}

static void screen(void) {
    for (uint32_t at = 0; at < 8 << 10; at += 4) REGISTER(CHARACTERS + at) = 0x20202020;
    draw(0xC2345678, 0xFFFF), draw(0xC3FC4180, 0xFFFF);
    PIXEL_BACK_BUFFER = 0xC2345678;
    swap();
    show(1);
    PIXEL_BACK_BUFFER = 0xC3FC4180;  // to the last byte of the SDRAM
    swap();
    show(2);
    PIXEL_STATUS = 0;
    show(3);
}

static void characters(void) {
    fact(20, TEXT_RESOLUTION == 0x003C0050 && TEXT_BACK == CHARACTERS);
    fact(21, TEXT_STATUS & EN);
    BYTE(CHARACTERS) = 'F', BYTE(CHARACTERS + 79) = 'P';
    REGISTER(CHARACTERS + 80) = 0x58585858;  // after the row, and after the last row: not shown
    REGISTER(CHARACTERS + (60 << 7)) = 0x58585858;
    draw(SDRAM, 0);
    PIXEL_STATUS = EN, PIXEL_BACK_BUFFER = SDRAM;
    swap();
    show(4);
    TEXT_BUFFER = 1 << 16;
    while (TEXT_BUFFER & 1 << 16) {
    }
    fact(22, BYTE(CHARACTERS) == ' ' && BYTE(CHARACTERS + (59 << 7) + 79) == ' ');
}

int main(void) {
    controller();
    memories();
    screen();
    characters();
    LEDR_DATA = ALL_LEDS;
    return 0;
}
