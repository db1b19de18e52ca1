// mmio.h - how the firmware reaches registers and memory of the board; each target implements it.
#pragma once

#include <cstdint>

namespace hal {

class Mmio {
public:
    // One aligned 32-bit access.  At an address without a target it is a data abort and does not
    // return.
    virtual std::uint32_t read(std::uint32_t address) = 0;
    virtual void write(std::uint32_t address, std::uint32_t value) = 0;

    // `count` words to rising addresses, as bursts where the target has them.
    virtual void write_words(std::uint32_t address, const std::uint32_t* words, unsigned count) = 0;

protected:
    ~Mmio() = default;
};

}  // namespace hal
