// i2c_target.h - the wire side of a device on an I2C bus: finds the bytes, acknowledges or refuses.
//
// It listens from START to STOP or to the first byte that it refuses.  Where the address is that of
// a read, it sends bytes until the master does not acknowledge one.
//
// Not handled: stretching of the clock.
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

    // The next byte of a read.
    using Next = std::function<std::uint8_t()>;

    I2cTarget(
        Byte on_byte, End on_end, Next next = [] { return std::uint8_t{0xFF}; })
        : on_byte_{std::move(on_byte)}, on_end_{std::move(on_end)}, next_{std::move(next)} {}

    // The levels of the wires, whenever one of them may have changed.
    void drive(bool scl, bool sda, std::uint64_t time_ps);

    // The shortest time from one rise of SCL to the next since START.
    std::uint64_t shortest_ps() const { return shortest_ps_; }

    bool pulls_low() const {
        return acknowledging_ || (sending_ && bits_ < 8 && !(value_ >> (7 - bits_) & 1));
    }

private:
    static constexpr std::uint64_t NONE = ~std::uint64_t{0};

    void begin_or_end(bool start);
    void bit_ends();
    void sent_bit_ends();

    Byte on_byte_;
    End on_end_;
    Next next_;
    bool scl_ = true, sda_ = true;
    bool listening_ = false, acknowledging_ = false;
    bool reads_ = false, sending_ = false;  // reads_: the address said so
    bool clocked_ = false;                  // SCL has risen since START or since the bit before
    bool bit_ = false;                      // SDA when it rose
    std::uint8_t value_ = 0;                // received so far, or sent
    unsigned bits_ = 0, bytes_ = 0;
    std::uint64_t rose_ps_ = 0, shortest_ps_ = NONE;
};

}  // namespace sim
