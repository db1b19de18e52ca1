// processor.cpp - see processor.h.  Addresses: Cortex-A9 MPCore TRM, private memory at 0xFFFEC000.
#include "processor.h"

#include <arm_neon.h>

namespace bare {

namespace {

constexpr std::uint32_t TIMER_LOAD = 0xFFFEC600, TIMER_CONTROL = 0xFFFEC608,
                        TIMER_STATUS = 0xFFFEC60C, ICCICR = 0xFFFEC100, ICCPMR = 0xFFFEC104,
                        ICCIAR = 0xFFFEC10C, ICCEOIR = 0xFFFEC110, ICDDCR = 0xFFFED000,
                        ICDISER0 = 0xFFFED100;
constexpr std::uint32_t TIMER_ID = 29, ONCE_WITH_INTERRUPT = 1 | 4;
constexpr std::uint32_t FIFTY_US = 50 * 200 - 1;  // at PERIPHCLK, 200 MHz

volatile std::uint32_t* at(std::uint32_t address) {
    return reinterpret_cast<volatile std::uint32_t*>(address);
}

}  // namespace

std::uint32_t Registers::read(std::uint32_t address) { return *at(address); }

void Registers::write(std::uint32_t address, std::uint32_t value) { *at(address) = value; }

void Registers::write_words(std::uint32_t address, const std::uint32_t* words, unsigned count) {
    auto* to = reinterpret_cast<std::uint32_t*>(address);
    for (; count >= 4; count -= 4, to += 4, words += 4) vst1q_u32(to, vld1q_u32(words));
    for (; count > 0; --count) *at(reinterpret_cast<std::uintptr_t>(to++)) = *words++;
    asm volatile("dsb" ::: "memory");  // before the next write to a register
}

Processor::Processor(hal::Mmio& io) : io_{io}, clock_{io}, console_{io} {
    clock_.start();
    io_.write(ICDISER0, 1u << TIMER_ID);
    io_.write(ICDDCR, 1);
    io_.write(ICCPMR, 0xff);
    io_.write(ICCICR, 1);
}

void Processor::idle() {
    io_.write(TIMER_LOAD, FIFTY_US);
    io_.write(TIMER_CONTROL, ONCE_WITH_INTERRUPT);
    asm volatile("dsb \n wfi" ::: "memory");
    io_.write(TIMER_CONTROL, 0);
    io_.write(TIMER_STATUS, 1);
    const std::uint32_t id = io_.read(ICCIAR);
    if ((id & 0x3ff) == TIMER_ID) io_.write(ICCEOIR, id);
}

}  // namespace bare
