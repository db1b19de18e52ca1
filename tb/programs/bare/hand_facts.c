// hand_facts.c - facts about interrupts, and about keys, pins, mouse and remote control
//
// HEX0 shows what the scenario has to do: 1 press KEY2, 2 hold HPS_KEY, 3 let go of it, 4 pull JP1
// D20 low, 5 move the mouse in the second PS/2 port, 6 release JP1 D20, 7 press the remote control.
#include "processor.h"
#include "facts.h"

#define JP(number, offset) REGISTER(0xFF200060 + 0x10 * (number) + (offset))
#define PS2(number, offset) REGISTER(0xFF200100 + 8 * (number) + (offset))
#define GPIO1(offset) REGISTER(0xFF709000 + (offset))
#define ICDICER(id) REGISTER(0xFFFED180 + (id) / 32 * 4)

enum { DATA = 0, DIRECTION = 4, MASK = 8, EDGE = 12, CONTROL = 4 };
enum { D20 = 1 << 20, LED = 1 << 24, KEY_UP = 1 << 25, NONE = 1023 };

// The interrupt that comes, as the GIC names it.
static uint32_t interrupt(void) {
    uint32_t id = NONE;
    for (int i = 0; i < 20 && id == NONE; ++i, wait_us(500)) id = ICCIAR;
    if (id != NONE) ICCEOIR = id;
    return id;
}

// With the GIC set up, the interrupt comes; `on` is the value that enables it in the block's
// register.
static void fact_of(uint32_t id, volatile uint32_t* mask, uint32_t on) {
    fact(id, ICCIAR == NONE);
    interrupt_on(id);
    *mask = on;
    fact(id, interrupt() == id);
    *mask = 0;
    ICDICER(id) = 1u << id % 32;
}

static void interrupts(void) {
    A9_TIMER_LOAD = 100;
    interrupt_on(29);
    A9_TIMER_CONTROL = 5;
    uint32_t id;
    while ((id = ICCIAR) == NONE) {
    }
    A9_TIMER_CONTROL = 0, A9_TIMER_STATUS = 1, ICCEOIR = id, ICDICER(29) = 1u << 29;
    fact(29, id == 29);
    for (uint32_t timer = 0; timer < 2; ++timer) {
        volatile uint32_t* registers = &REGISTER(0xFF202000 + 0x20 * timer);
        registers[2] = 100, registers[3] = 0, registers[1] = 4;
        fact_of(72 + 2 * timer, &registers[1], 1);
        registers[0] = 0;
    }
    fact_of(78, &AUDIO_CONTROL, 2);
    fact_of(80, &JTAG_UART0_CONTROL, 2);
    fact_of(81, &IRDA_CONTROL, 2);
    for (uint32_t jp = 0; jp < 2; ++jp) {
        JP(jp, DIRECTION) = 2, JP(jp, DATA) = 2, JP(jp, DATA) = 0;
        fact(83 + jp, JP(jp, EDGE) == 2);
        fact_of(83 + jp, &JP(jp, MASK), 2);
        JP(jp, EDGE) = ~2u;
        fact(83 + jp, JP(jp, EDGE) == 2);
        JP(jp, EDGE) = 2;
        fact(83 + jp, JP(jp, EDGE) == 0);
        JP(jp, DIRECTION) = 0;
        fact(83 + jp, JP(jp, DATA) == 0xFFFFFFFF && JP(jp, DIRECTION) == 0);
    }
    static const uint32_t hps[] = {0xFFC08000, 0xFFC09000, 0xFFD00000, 0xFFD01000};
    for (uint32_t i = 0; i < 4; ++i) {
        REGISTER(hps[i]) = 100;
        interrupt_on(199 + i);
        REGISTER(hps[i] + 8) = 3;
        fact(199 + i, interrupt() == 199 + i);
        REGISTER(hps[i] + 8) = 0;
        (void)REGISTER(hps[i] + 12);
        ICDICER(199 + i) = 1u << (199 + i) % 32;
    }
}

static void keys(void) {
    HEX3_0_DATA = DIGITS[1];
    while (KEY_DATA == 0) {
    }
    fact(300, KEY_DATA == 4);
    while (KEY_DATA) {
    }
    fact(301, KEY_EDGE == 4);
    fact_of(73, &KEY_MASK, 4);
    KEY_EDGE = 0xB;
    fact(302, KEY_EDGE == 4);
    KEY_EDGE = 4;
    fact(303, KEY_EDGE == 0);
    GPIO1(4) = LED, GPIO1(0) = LED;
    fact(310, GPIO1(0x50) & LED && GPIO1(0x50) & KEY_UP);
    HEX3_0_DATA = DIGITS[2];
    while (GPIO1(0x50) & KEY_UP) {
    }
    GPIO1(0x38) = 0, GPIO1(0x34) = ~(uint32_t)KEY_UP;  // the level, low
    fact_of(197, &GPIO1(0x30), KEY_UP);
    HEX3_0_DATA = DIGITS[3];
    while ((GPIO1(0x50) & KEY_UP) == 0) {
    }
}

static void pins(void) {
    HEX3_0_DATA = DIGITS[4];
    while (JP(0, DATA) & D20) {
    }
    fact(320, JP(0, DATA) == (0xFFFFFFFF & ~(uint32_t)D20) && JP(0, EDGE) == D20);
    JP(0, EDGE) = D20;
    fact(321, JP(0, EDGE) == 0 && JP(1, EDGE) == 0);
}

static uint32_t answer(void) {
    uint32_t data = 0;
    for (int i = 0; i < 2000 && (data & 0x8000) == 0; ++i, wait_us(500)) data = PS2(1, DATA);
    return data;
}

static void mouse(void) {
    fact(329, (answer() & 0xFF) == 0xAA && (answer() & 0xFF) == 0);  // of its test at power-on
    PS2(1, DATA) = 0xFF;
    fact(330, (answer() & 0xFF) == 0xFA && (answer() & 0xFF) == 0xAA && (answer() & 0xFF) == 0);
    PS2(1, DATA) = 0xF4;
    fact(331, (answer() & 0xFF) == 0xFA && PS2(1, DATA) >> 15 == 0);
    fact(332, (PS2(1, CONTROL) & 0x500) == 0);  // neither RI nor CE
    PS2(1, CONTROL) = 1;                        // RI is of an interrupt that was asked for
    HEX3_0_DATA = DIGITS[5];
    while ((PS2(1, CONTROL) & 0x100) == 0) {
    }
    PS2(1, CONTROL) = 0;
    wait_us(20000);
    const uint32_t first = PS2(1, DATA), x = PS2(1, DATA), y = PS2(1, DATA);
    fact(333, first >> 15 == (3 << 1 | 1) && x >> 15 == (2 << 1 | 1) && y >> 15 == (1 << 1 | 1));
    fact(334, (first & 0xFF) == 0x08 && (x & 0xFF) == 5 && (y & 0xFF) == 0);
    fact(335, (PS2(0, DATA) & 0xFF) == 0xAA && PS2(0, DATA) >> 15 == 0);
    PS2(0, DATA) = 0xFF;  // the keyboard's answer is the interrupt, and in the first port alone
    fact_of(79, &PS2(0, CONTROL), 1);
    fact(336, (PS2(0, DATA) & 0xFF) == 0xFA && PS2(1, DATA) >> 15 == 0);
}

static void light(void) {
    fact(340, IRDA_DATA == 0);
    HEX3_0_DATA = DIGITS[7];
    uint32_t data;
    while (((data = IRDA_DATA) & 0x8000) == 0) {
    }
    fact(341, (data & 0xFF) == 0 && (data >> 16 & 0xFF) >= 1);
}

int main(void) {
    interrupts();
    keys();
    pins();
    mouse();
    HEX3_0_DATA = DIGITS[6];
    while ((JP(0, DATA) & D20) == 0) {
    }
    light();
    LEDR_DATA = ALL_LEDS;
    return 0;
}
