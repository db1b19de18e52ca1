// de10_lite.c - checks the DE10-Lite Computer's map: LEDR shows all LEDs, or the number of the check
// that fails.
#include <stdint.h>

#define R32(address) (*(volatile uint32_t*)(address))
#define R16(address) (*(volatile uint16_t*)(address))
#define R8(address) (*(volatile uint8_t*)(address))
#define LEDS R32(0xFF200000)
#define CHECK(number, condition) \
    if (!(condition)) {          \
        LEDS = number;           \
        for (;;) {               \
        }                        \
    }

enum { ONCHIP = 0x08000000, ARDUINO = 0xFF200100, SENSOR = 0xFF204020, ADC = 0xFF204000 };

static uint32_t pending(void) {
    uint32_t mip;
    __asm volatile("csrr %0, mip" : "=r"(mip));
    return mip;
}

static uint8_t sensor(uint8_t number) {
    R8(SENSOR) = number;
    return R8(SENSOR + 1);
}

int main(void) {
    // The picture: 160 x 120, in two memories.
    CHECK(1, R32(0xFF203028) == 0x007800A0 && R32(0xFF20302C) == 0x07080F04);
    CHECK(2, R32(0xFF203020) == ONCHIP && R32(0xFF203024) == ONCHIP);
    R32(0xFF203024) = 0x02000000;
    R32(0xFF203020) = 1;
    CHECK(3, R32(0xFF20302C) & 1);
    while (R32(0xFF20302C) & 1) {
    }
    CHECK(4, R32(0xFF203020) == 0x02000000 && R32(0xFF203024) == ONCHIP);

    // The on-chip memory, 64 KB.
    for (uint32_t at = ONCHIP; at < ONCHIP + 0x10000; at += 0x1F4) R32(at) = at * 0x9E3779B1;
    R8(ONCHIP + 0x1F5) = 0x5A;
    R16(ONCHIP + 0x3EA) = 0x1234;
    CHECK(5, R32(ONCHIP + 0x1F4) == (((ONCHIP + 0x1F4) * 0x9E3779B1 & ~0xFF00u) | 0x5A00));
    CHECK(6, R32(ONCHIP + 0x3E8) == (((ONCHIP + 0x3E8) * 0x9E3779B1 & 0xFFFF) | 0x12340000));
    for (uint32_t at = ONCHIP + 0x5DC; at < ONCHIP + 0x10000; at += 0x1F4)
        CHECK(7, R32(at) == at * 0x9E3779B1);

    // What no block takes is the SDRAM's.
    R32(0xFF203040) = 0x11223344;
    CHECK(8, R32(0x03203040) == 0x11223344 && R32(0xFF203040) == 0x11223344);
    R32(0xFF200040) = 0x55667788;
    CHECK(9, R32(0x03200040) == 0x55667788 && R32(0xFF200040) == 0);
    R32(0x08020000) = 0x99AABBCC;
    CHECK(10, R32(0x00020000) == 0x99AABBCC);

    // Two keys.
    R32(0xFF200058) = 0xF;
    CHECK(11, R32(0xFF200058) == 3);
    CHECK(12, R32(0xFF203010) == 0x00190014 && R32(0xFF202040) == 0);

    // The Arduino header: an input that nothing drives is 1; edges fall.
    CHECK(13, R32(ARDUINO) == 0xFFFF);
    R32(ARDUINO) = 0x0004;
    R32(ARDUINO + 4) = 0x0007;
    CHECK(14, R32(ARDUINO) == 0xFFFC && R32(ARDUINO + 12) == 3 && !(pending() >> 29 & 1));
    R32(ARDUINO + 8) = 2;
    CHECK(15, pending() >> 29 & 1);
    R32(ARDUINO + 12) = 3;
    CHECK(16, R32(ARDUINO + 12) == 0 && !(pending() >> 29 & 1));
    R32(0xFF200110) = 1;
    CHECK(17, R32(0xFF200110) == 1);

    // The accelerometer: set up by its port; data ready at INT1, which is the port's.
    CHECK(18, sensor(0x00) == 0xE5 && R8(SENSOR) == 0x00);
    CHECK(19, sensor(0x2D) == 0x08 && sensor(0x2C) == 0x09 && sensor(0x31) == 0x40);
    R8(SENSOR) = 0x2E;
    R8(SENSOR + 1) = 0x80;
    CHECK(20, sensor(0x2E) == 0x80);
    while (!(pending() >> 31)) {
    }
    CHECK(21, (int16_t)(sensor(0x36) | sensor(0x37) << 8) == 256);  // 1 g

    // The converter: 3 V at the third input.
    CHECK(22, R32(ADC + 8) == 0);
    R32(ADC) = 1;
    CHECK(23, R32(ADC + 8) == 2457 && R32(ADC + 4) == 0);
    R32(ADC + 4) = 1;
    while (!(R32(ADC + 8) & 0x8000)) {
    }
    CHECK(24, (R32(ADC + 8) & 0xFFF) == 2457 && R32(ADC + 24) == 0);
    LEDS = 0x3FF;
    for (;;) {
    }
}
