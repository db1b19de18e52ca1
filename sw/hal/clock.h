// clock.h - driver for the Cortex-A9's global timer: time since power-on.
#pragma once

#include <cstdint>

#include "hal/mmio.h"

namespace hal {

class Clock {
public:
    explicit Clock(Mmio& io) : io_{io} {}

    // May be called while it runs: it counts on from its value.
    void start() { io_.write(CONTROL, 1); }

    // Microseconds, modulo 2^32: subtract two values to get a time span of up to 71 minutes.  0
    // until it is started.
    std::uint32_t micros() const {
        std::uint32_t high = io_.read(HIGH), low, again;
        for (;; high = again) {  // once more only if the low word has just wrapped
            low = io_.read(LOW);
            again = io_.read(HIGH);
            if (again == high) break;
        }
        const std::uint64_t ticks = static_cast<std::uint64_t>(high) << 32 | low;
        return static_cast<std::uint32_t>(ticks / TICKS_PER_US);
    }

private:
    // Cortex-A9 MPCore TRM, private memory region at 0xFFFEC000 + 0x200.
    static constexpr std::uint32_t LOW = 0xFFFEC200, HIGH = 0xFFFEC204, CONTROL = 0xFFFEC208;
    static constexpr unsigned TICKS_PER_US = 200;

    Mmio& io_;
};

}  // namespace hal
