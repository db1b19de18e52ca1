// level.c - a spirit level: the lit LED is where the bubble is, by the accelerometer on the HPS's I2C0.
//
// The accelerometer (ADXL345) says at its INT1, GPIO61 of the HPS, that there is a new sample.
#include "registers.h"

#define I2C(offset) REGISTER(0xFFC04000 + (offset))
#define GPIO2_PINS REGISTER(0xFF70A050)

enum { CON = 0x00, TAR = 0x04, DATA_CMD = 0x10, FS_HCNT = 0x1C, FS_LCNT = 0x20, ENABLE = 0x6C,
       RXFLR = 0x78, ENABLE_STATUS = 0x9C };
enum { READS = 0x100, STOP = 0x200, START_AGAIN = 0x400 };
enum { ADXL345 = 0x53, POWER_CTL = 0x2D, INT_ENABLE = 0x2E, DATA_FORMAT = 0x31, DATAX0 = 0x32 };
enum { INT1 = 1 << 3, G = 256 };

static void open_bus(void) {
    I2C(ENABLE) = 0;
    while (I2C(ENABLE_STATUS) & 1) {
    }
    I2C(CON) = 0x65;  // a master, 400 kHz, may start again
    I2C(TAR) = ADXL345;
    I2C(FS_HCNT) = 90;
    I2C(FS_LCNT) = 160;
    I2C(ENABLE) = 1;
}

static void put(uint32_t number, uint32_t value) {
    I2C(DATA_CMD) = START_AGAIN | number;
    I2C(DATA_CMD) = STOP | value;
}

static int32_t x(void) {
    I2C(DATA_CMD) = START_AGAIN | DATAX0;
    for (int i = 0; i < 5; ++i) I2C(DATA_CMD) = READS;
    I2C(DATA_CMD) = READS | STOP;
    while (I2C(RXFLR) < 6) {
    }
    const uint32_t low = I2C(DATA_CMD), high = I2C(DATA_CMD);
    for (int i = 0; i < 4; ++i) (void)I2C(DATA_CMD);  // y and z
    return (int16_t)(low | high << 8);
}

int main(void) {
    open_bus();
    put(DATA_FORMAT, 0x08);  // full resolution, +-2 g
    put(INT_ENABLE, 0x80);   // of each sample
    put(POWER_CTL, 0x08);    // measure
    for (;;) {
        while (!(GPIO2_PINS & INT1)) {
        }
        int32_t bubble = 5 + x() * 5 / G;  // it rises; LED 9 is at the left
        if (bubble < 0) bubble = 0;
        if (bubble > 9) bubble = 9;
        LEDR_DATA = 1u << bubble;
    }
}
