// processor.h - registers and the Cortex-A9 as the firmware asks for them, with nothing in between.
#pragma once

#include "hal/clock.h"
#include "hal/console.h"
#include "hal/cpu.h"
#include "hal/mmio.h"

namespace bare {

class Registers : public hal::Mmio {
public:
    std::uint32_t read(std::uint32_t address) override;
    void write(std::uint32_t address, std::uint32_t value) override;
    // Four words per instruction, which the store buffer may join to a burst.  Complete when it
    // returns.
    void write_words(std::uint32_t address, const std::uint32_t* words, unsigned count) override;
};

class Processor : public hal::Cpu {
public:
    // Starts the global timer, and sets up the private timer and the interrupt controller to wake
    // the processor.  Interrupts stay masked: WFI ends even so.
    explicit Processor(hal::Mmio& io);

    void idle() override;  // 50 us in WFI
    std::uint32_t micros() override { return clock_.micros(); }
    void print(const char* text) override { console_.print(text); }

private:
    hal::Mmio& io_;
    hal::Clock clock_;
    hal::Console console_;
};

}  // namespace bare
