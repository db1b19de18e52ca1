// processor.h - the processor's own registers that these programs use: its timer, its interrupts
//
// Source: Cortex-A9 MPCore TRM; ARM Generic Interrupt Controller, version 1.
#pragma once

#include "registers.h"

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

// Segments g..a of the digits 0 - 9, A - F.
static const uint8_t DIGITS[16] = {0x3F, 0x06, 0x5B, 0x4F, 0x66, 0x6D, 0x7D, 0x07,
                                   0x7F, 0x6F, 0x77, 0x7C, 0x39, 0x5E, 0x79, 0x71};

// Lets interrupt `id` through to the first processor; IRQ in the CPSR stays as it is.
static inline void interrupt_on(unsigned id) {
    ICDIPTR(id) = 1;
    ICDISER(id) = 1u << id % 32;
    ICCPMR = 0xFFFF;
    ICCICR = 1;
    ICDDCR = 1;
}
