// registers.h - the registers that these programs use, as the DE1-SoC Computer lists them.
#pragma once

#include <stdint.h>

#define REGISTER(address) (*(volatile uint32_t*)(address))

#define LEDR REGISTER(0xFF200000)
#define HEX3_0 REGISTER(0xFF200020)
#define HEX5_4 REGISTER(0xFF200030)
#define SW REGISTER(0xFF200040)
#define KEY REGISTER(0xFF200050)
#define KEY_MASK REGISTER(0xFF200058)
#define KEY_EDGE REGISTER(0xFF20005C)
#define JP1 REGISTER(0xFF200060)
#define JP1_DIRECTION REGISTER(0xFF200064)
#define PS2_DATA REGISTER(0xFF200100)
#define PS2_CONTROL REGISTER(0xFF200104)
#define JTAG_UART_DATA REGISTER(0xFF201000)
#define JTAG_UART_CONTROL REGISTER(0xFF201004)
#define AV_CONFIG_STATUS REGISTER(0xFF203004)
#define AV_CONFIG_ADDRESS REGISTER(0xFF203008)
#define AV_CONFIG_DATA REGISTER(0xFF20300C)
#define RESAMPLER_STATUS REGISTER(0xFF203010)
#define PIXEL_BUFFER REGISTER(0xFF203020)
#define PIXEL_BACK REGISTER(0xFF203024)
#define PIXEL_RESOLUTION REGISTER(0xFF203028)
#define PIXEL_STATUS REGISTER(0xFF20302C)
#define AUDIO_CONTROL REGISTER(0xFF203040)
#define AUDIO_SPACE REGISTER(0xFF203044)
#define AUDIO_LEFT REGISTER(0xFF203048)
#define AUDIO_RIGHT REGISTER(0xFF20304C)

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
