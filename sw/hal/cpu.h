// cpu.h - what the firmware asks of the processor itself; each target implements it.
#pragma once

#include <cstdint>

namespace hal {

class Cpu {
public:
    // Nothing to do: sleeps for a while, at most 100 us.
    virtual void idle() = 0;

    // Microseconds since some moment, modulo 2^32: subtract two to get a time span.
    virtual std::uint32_t micros() = 0;

    // To the console, whatever that is here; a line ends in "\n".
    virtual void print(const char* text) = 0;

protected:
    ~Cpu() = default;
};

}  // namespace hal
