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
enum { TIMER1_INTERRUPT = 17, KEY_INTERRUPT = 18, AUDIO_INTERRUPT = 21, PS2_INTERRUPT = 22 };

#define MTIME_LOW REGISTER(0xFF202100)  // counts at 100 MHz

#define INTERRUPT_HANDLER void __attribute__((interrupt("machine")))

// Lets interrupt `id` through to the processor; MIE in mstatus stays as it is.
static inline void interrupt_on(unsigned id) { __asm volatile("csrs mie, %0" ::"r"(1u << id)); }
static inline void interrupts_enable(void) { __asm volatile("csrsi mstatus, 8"); }

static inline uint32_t interrupt_begin(void) {
    uint32_t cause;
    __asm volatile("csrr %0, mcause" : "=r"(cause));
    return cause & 31;
}
static inline void interrupt_end(uint32_t id) { (void)id; }

#else

enum { TIMER1_INTERRUPT = 74, KEY_INTERRUPT = 73, AUDIO_INTERRUPT = 78, PS2_INTERRUPT = 79 };

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

// The interrupt controller then waits for interrupt_end().
static inline uint32_t interrupt_begin(void) { return ICCIAR; }
static inline void interrupt_end(uint32_t id) { ICCEOIR = id; }

#endif
