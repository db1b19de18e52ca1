// i2c_target.h - the wire side of a device on an I2C bus: finds the bytes, acknowledges or refuses.
//
// It listens from START to STOP or to the first byte that it refuses.
//
// Not handled: transfers that read, stretching of the clock.
#pragma once

#include <cstdint>
#include <functional>

namespace sim {

class I2cTarget {
public:
    // Whether a byte is acknowledged.  Number 0 holds the address (7:1) and 1 for a read (0).
    using Byte = std::function<bool(unsigned number, std::uint8_t value)>;
    // START or STOP while it listened: bytes acknowledged, and bits of one that was cut off.
    using End = std::function<void(unsigned bytes, unsigned bits)>;

    I2cTarget(Byte on_byte, End on_end)
        : on_byte_{std::move(on_byte)}, on_end_{std::move(on_end)} {}

    // The levels of the wires, whenever one of them may have changed.
    void drive(bool scl, bool sda);

    bool pulls_low() const { return acknowledging_; }

private:
    void begin_or_end(bool start);
    void bit_ends();

    Byte on_byte_;
    End on_end_;
    bool scl_ = true, sda_ = true;
    bool listening_ = false, acknowledging_ = false;
    bool clocked_ = false;  // SCL has risen since START or since the bit before
    bool bit_ = false;      // SDA when it rose
    std::uint8_t value_ = 0;
    unsigned bits_ = 0, bytes_ = 0;
};

}  // namespace sim
