// register_facts.c - facts about the registers
#include "processor.h"
#include "facts.h"

#define JP2 REGISTER(0xFF200070)
#define JP2_DIRECTION REGISTER(0xFF200074)
#define RESAMPLER REGISTER(0xFF203010)
#define GPIO1 REGISTER(0xFF709000)
#define GPIO1_DIRECTION REGISTER(0xFF709004)
#define BRIDGE_RESETS REGISTER(0xFFD0501C)
#define ON_CHIP_RAM 0xFFFF0000
#define A9_TIMER_COUNTER REGISTER(0xFFFEC604)

enum { DEPTH = 128 };

static void ports(void) {
    LEDR_DATA = 0xFFFFFFFF;
    fact(1, LEDR_DATA == ALL_LEDS);
    LEDR_DATA = 0;
    HEX3_0_DATA = 0x5B3F0679, HEX5_4_DATA = 0x00003F06;
    fact(2, HEX3_0_DATA == 0x5B3F0679 && HEX5_4_DATA == 0x00003F06);
    KEY_MASK = 0xF;
    fact(3, KEY_MASK == 0xF && KEY_EDGE == 0 && KEY_DATA == 0 && SW_DATA == 0);
    KEY_MASK = 0;
    fact(4, JP1_DIR == 0 && JP1_DATA == 0xFFFFFFFF && JP2 == 0xFFFFFFFF);
    JP2_DIRECTION = 0xFFFF0000, JP2 = 0x12345678;
    fact(5, JP2_DIRECTION == 0xFFFF0000 && JP2 == 0x1234FFFF);
    fact(22, IRDA_DATA == 0 && IRDA_CONTROL == 0x00800000);
}

static void picture(void) {
    fact(6, PIXEL_RESOLUTION == 0x00F00140 && (PIXEL_STATUS & ~1u) == 0x08090F04);
    fact(7, RESAMPLER == 0x00190014 && PIXEL_BUFFER == 0xC8000000);
    PIXEL_BACK_BUFFER = 0xC0000000;
    fact(8, PIXEL_BACK_BUFFER == 0xC0000000);
    PIXEL_BUFFER = 0x12345678;  // asks for the swap and is not loaded
    fact(9, PIXEL_BUFFER == 0xC8000000 && PIXEL_STATUS & 1);
    while (PIXEL_STATUS & 1) {
    }
    fact(10, PIXEL_BUFFER == 0xC0000000 && PIXEL_BACK_BUFFER == 0xC8000000);
    REGISTER(0xC803FFFC) = 1, REGISTER(0xC8040000) = 2, REGISTER(0xC8041000) = 3;
    *(volatile uint16_t*)0xC8000280 = 0xF81F;  // after the 320th pixel of a row: not shown
    *(volatile uint16_t*)0xC800027E = 0x07E0;
    fact(11, *(volatile uint16_t*)0xC800027E == 0x07E0);
}

static void camera(void) {
    fact(23, VIDEO_IN_BUFFER == 0xC8000000 && VIDEO_IN_BACK_BUFFER == 0xC8000000);
    fact(24, VIDEO_IN_RESOLUTION == 0x00F00140 && VIDEO_IN_STATUS == 0x08090F00);
    EDGE_DETECTION_CONTROL = 0xFFFFFFFF;
    fact(25, EDGE_DETECTION_CONTROL == 1);
    EDGE_DETECTION_CONTROL = 0, VIDEO_IN_BACK_BUFFER = 0xC0040000;
    fact(26, EDGE_DETECTION_CONTROL == 0 && VIDEO_IN_BACK_BUFFER == 0xC0040000);
    REGISTER(0xC0040000) = 0x12345678;
    VIDEO_IN_BUFFER = 0x12345678;  // asks for the swap and is not loaded
    fact(27, VIDEO_IN_BUFFER == 0xC8000000 && VIDEO_IN_STATUS == 0x08090F01);
    VIDEO_IN_STATUS = 4;
    fact(28, VIDEO_IN_STATUS == 0x08090F05);
    while (VIDEO_IN_STATUS & 1) {
    }
    fact(29, VIDEO_IN_BUFFER == 0xC0040000 && VIDEO_IN_BACK_BUFFER == 0xC8000000);
    for (int i = 0; i < 2; ++i) {  // a picture into each
        VIDEO_IN_BUFFER = 1;
        while (VIDEO_IN_STATUS & 1) {
        }
    }
    VIDEO_IN_STATUS = 0;  // no camera: blue
    fact(30, VIDEO_IN_STATUS == 0x08090F00 && REGISTER(0xC0040000) == 0x10F510F5);
    fact(31, REGISTER(0xC0040000) == REGISTER(0xC8000000));
}

static void sound(void) {
    fact(12, AUDIO_FIFOSPACE >> 24 == DEPTH && (AUDIO_FIFOSPACE >> 16 & 0xFF) == DEPTH);
    for (int i = 0; i < 2 * DEPTH; ++i) AUDIO_LEFTDATA = 0;  // what does not fit is dropped
    fact(13, AUDIO_FIFOSPACE >> 24 == 0 && (AUDIO_FIFOSPACE >> 16 & 0xFF) == DEPTH);
    A9_TIMER_LOAD = 200000, A9_TIMER_CONTROL = 1;  // 1 ms: no left one leaves without a right one
    const uint32_t earlier = A9_TIMER_COUNTER;
    while (A9_TIMER_STATUS == 0) {
    }
    fact(14, earlier <= 200000 && earlier > 190000 && A9_TIMER_COUNTER == 0);
    fact(15, AUDIO_FIFOSPACE >> 24 == 0);
    AUDIO_RIGHTDATA = 0;
    A9_TIMER_STATUS = 1, A9_TIMER_LOAD = 200000;
    while (A9_TIMER_STATUS == 0) {
    }
    fact(16, AUDIO_FIFOSPACE >> 24 == 1 && (AUDIO_FIFOSPACE >> 16 & 0xFF) == DEPTH);
    AUDIO_CONTROL = 8;
    fact(17, AUDIO_FIFOSPACE >> 24 == 0);
    AUDIO_CONTROL = 0;
}

static void processor_side(void) {
    GPIO1_DIRECTION = 1u << 24, GPIO1 = 1u << 24;
    fact(18, GPIO1_DIRECTION == 1u << 24 && GPIO1 == 1u << 24);
    fact(19, (BRIDGE_RESETS & 3) == 0);
    REGISTER(ON_CHIP_RAM) = 0x5A5A5A5A;
    REGISTER(0x3FFFF000) = 0xA5A5A5A5;
    fact(20, REGISTER(ON_CHIP_RAM) == 0x5A5A5A5A && REGISTER(0x3FFFF000) == 0xA5A5A5A5);
    volatile float half = 0.5f;
    fact(21, half + half == 1.0f);
}

int main(void) {
    ports();
    picture();
    camera();
    sound();
    processor_side();
    LEDR_DATA = ALL_LEDS;
    return 0;
}
