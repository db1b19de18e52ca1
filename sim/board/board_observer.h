// board_observer.h - where what the board shows, plays and prints goes.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "sim/board/monitor.h"
#include "sim/pins/chip.h"
#include "sim/pins/pins.h"

namespace sim {

// What can be seen without a monitor.
struct Lamps {
    struct Header {
        std::uint64_t levels = ALL_HEADER_PINS, outputs = 0;  // bit n is GPIO_x[n]
        bool operator==(const Header& o) const {
            return levels == o.levels && outputs == o.outputs;
        }
    };
    std::uint32_t ledr = 0;
    std::uint64_t hex = 0;  // segments and points as in LampPins, 1 = lit
    bool hps_led = false;
    std::array<Header, HEADERS> gpio{};
};

class BoardObserver : public ChipObserver {
public:
    virtual void frame(const Monitor::Frame& frame) = 0;
    virtual void sample(std::int16_t left, std::int16_t right) = 0;
    virtual void sample_rate(double hz) = 0;
    // Whenever one of them is seen otherwise than before.
    virtual void lamps(const Lamps& /*lamps*/, double /*time_s*/) {}

protected:
    ~BoardObserver() = default;
};

}  // namespace sim
