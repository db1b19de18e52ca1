// processor.h - the processor's own registers that these programs use: its timer, its interrupts
//
// A handler is INTERRUPT_HANDLER on_irq(void): interrupt_begin() says which interrupt it is,
// interrupt_end() that it has been served.
//
// Source: Cortex-A9 MPCore TRM; ARM Generic Interrupt Controller, version 1; Nios V Processor
// Reference Manual.
#pragma once

#include "registers.h"

// Segments g..a of the digits 0 - 9, A - F.
static const uint8_t DIGITS[16] = {0x3F, 0x06, 0x5B, 0x4F, 0x66, 0x6D, 0x7D, 0x07,
                                   0x7F, 0x6F, 0x77, 0x7C, 0x39, 0x5E, 0x79, 0x71};

#ifdef __riscv

// Bits of mie and mip.
enum {
    OWN_TIMER_INTERRUPT = 7,
    TIMER1_INTERRUPT = 17,
    KEY_INTERRUPT = 18,
    AUDIO_INTERRUPT = 21,
    PS2_INTERRUPT = 22
};

// The machine timer: counts at 100 MHz, and interrupts while it is not below what it is compared
// with.
#define MTIME_LOW REGISTER(0xFF202100)
#define MTIME_HIGH REGISTER(0xFF202104)
#define MTIMECMP_LOW REGISTER(0xFF202108)
#define MTIMECMP_HIGH REGISTER(0xFF20210C)
enum { OWN_TIMER_HZ = 100000000 };

#define INTERRUPT_HANDLER void __attribute__((interrupt("machine")))

// Lets interrupt `id` through to the processor; MIE in mstatus stays as it is.
static inline void interrupt_on(unsigned id) { __asm volatile("csrs mie, %0" ::"r"(1u << id)); }
static inline void interrupts_enable(void) { __asm volatile("csrsi mstatus, 8"); }
static inline void interrupts_disable(void) { __asm volatile("csrci mstatus, 8"); }

static inline uint32_t interrupt_begin(void) {
    uint32_t cause;
    __asm volatile("csrr %0, mcause" : "=r"(cause));
    return cause & 31;
}
static inline void interrupt_end(uint32_t id) { (void)id; }

static inline void own_timer_next(uint64_t time) {
    MTIMECMP_HIGH = 0xFFFFFFFF;  // so that no time in between is reached
    MTIMECMP_LOW = (uint32_t)time;
    MTIMECMP_HIGH = (uint32_t)(time >> 32);
}

// The processor's own timer interrupts every `clocks` clocks of OWN_TIMER_HZ.
static inline void own_timer_begin(uint32_t clocks) {
    uint32_t high, low;
    do {
        high = MTIME_HIGH;
        low = MTIME_LOW;
    } while (high != MTIME_HIGH);
    own_timer_next(((uint64_t)high << 32 | low) + clocks);
}

// In the handler: until the next time there is no interrupt.
static inline void own_timer_served(uint32_t clocks) {
    own_timer_next(((uint64_t)MTIMECMP_HIGH << 32 | MTIMECMP_LOW) + clocks);
}

#else

enum {
    OWN_TIMER_INTERRUPT = 29,
    TIMER1_INTERRUPT = 74,
    KEY_INTERRUPT = 73,
    AUDIO_INTERRUPT = 78,
    PS2_INTERRUPT = 79
};

// The private timer: counts down at 200 MHz.
enum { OWN_TIMER_HZ = 200000000 };
#define A9_TIMER_LOAD REGISTER(0xFFFEC600)
#define A9_TIMER_CONTROL REGISTER(0xFFFEC608)
#define A9_TIMER_STATUS REGISTER(0xFFFEC60C)

#define ICCICR REGISTER(0xFFFEC100)
#define ICCPMR REGISTER(0xFFFEC104)
#define ICCIAR REGISTER(0xFFFEC10C)
#define ICCEOIR REGISTER(0xFFFEC110)
#define ICDDCR REGISTER(0xFFFED000)
#define ICDISER(id) REGISTER(0xFFFED100 + (id) / 32 * 4)
#define ICDIPTR(id) (*(volatile uint8_t*)(0xFFFED800 + (id)))

#define INTERRUPT_HANDLER void __attribute__((interrupt("IRQ")))

// Lets interrupt `id` through to the first processor; IRQ in the CPSR stays as it is.
static inline void interrupt_on(unsigned id) {
    ICDIPTR(id) = 1;
    ICDISER(id) = 1u << id % 32;
    ICCPMR = 0xFFFF;
    ICCICR = 1;
    ICDDCR = 1;
}
static inline void interrupts_enable(void) { __asm volatile("cpsie i"); }
static inline void interrupts_disable(void) { __asm volatile("cpsid i"); }

// The interrupt controller then waits for interrupt_end().
static inline uint32_t interrupt_begin(void) { return ICCIAR; }
static inline void interrupt_end(uint32_t id) { ICCEOIR = id; }

// The processor's own timer interrupts every `clocks` clocks of OWN_TIMER_HZ.
static inline void own_timer_begin(uint32_t clocks) {
    enum { ENABLE = 1, AGAIN = 2, INTERRUPTS = 4 };
    A9_TIMER_LOAD = clocks - 1;
    A9_TIMER_CONTROL = ENABLE | AGAIN | INTERRUPTS;
}

// In the handler: until the next time there is no interrupt.
static inline void own_timer_served(uint32_t clocks) {
    (void)clocks;
    A9_TIMER_STATUS = 1;
}

#endif
