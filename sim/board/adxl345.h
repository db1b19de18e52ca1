// adxl345.h - "ADXL345 3-axis digital accelerometer" (Analog Devices) on an I2C bus, at 0x53.
//
//   0x00 DEVID, E5      0x1E - 0x20 offsets      0x2C rate        0x2D power       0x2E, 0x2F
//   0x30 interrupts     0x31 format              0x32 - 0x37 data    0x38, 0x39 FIFO
//
// A transfer's first written byte is the register, which then increments with each byte.  At the
// end of a transfer that read data the next sample of the FIFO comes up.  While the measure bit is
// set, a sample is taken at each period of the rate, 3200 Hz to 0.1 Hz, or 8 to 1 Hz asleep, from
// the moment on at which it was set.  The FIFO holds 32 samples, and one is in the data
// registers: bypass, FIFO and stream.  Interrupts: data ready, watermark, overrun, activity,
// inactivity, free fall; on the DE1-SoC INT1 goes to GPIO61 of the HPS, INT2 nowhere.
//
// Lying flat it measures 0, 0, 1 g; it has no noise.
//
// Source: ADXL345 data sheet, revision G.
//
// Not handled: taps, self-test, auto-sleep, the FIFO's trigger mode, SPI; these bits keep what is
// written.  It settles at once.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <optional>

#include "sim/board/part.h"

namespace sim {

class Adxl345 {
public:
    static constexpr std::uint8_t ADDRESS = 0x53;

    struct Acceleration {
        double x, y, z;  // in g, of what holds it up: at rest and flat 0, 0, 1
    };
    void move(const Acceleration& acceleration, std::uint64_t now_ps);

    // ---- I2C: as its master sees it ----
    void begin(bool reads);  // START, or START again, and this address
    void end();              // STOP
    void write(std::uint8_t byte, std::uint64_t now_ps);
    std::uint8_t read(std::uint64_t now_ps);

    // INT1, from the last access or advance() on; and when it may move by itself.
    bool int1() const;
    std::optional<std::uint64_t> next_ps() const;
    // Takes the samples up to now.
    void advance(std::uint64_t now_ps);

private:
    using Sample = std::array<std::int16_t, 3>;

    std::uint8_t get(std::uint8_t number) const;
    void set(std::uint8_t number, std::uint8_t value, std::uint64_t now_ps);
    std::uint64_t period_ps() const;
    void measure();
    void judge();
    Sample measured() const;
    void pop();
    bool measures() const;

    std::array<std::uint8_t, 0x3A> registers_{};
    std::uint8_t pointer_ = 0;
    bool register_next_ = true;
    bool data_read_ = false;  // in this transfer, at whose end the next sample comes up
    Acceleration acceleration_{0, 0, 1}, reference_{0, 0, 1};
    Sample data_{};       // in the data registers
    bool fresh_ = false;  // and not read yet
    bool overrun_ = false;
    std::deque<Sample> fifo_;
    std::uint8_t events_ = 0;  // activity, inactivity, free fall, until INT_SOURCE is read
    std::uint64_t still_ps_ = 0, falls_ps_ = 0;  // for how long
    std::uint64_t last_ps_ = 0;                  // of a sample, or when measuring began

public:
    Adxl345();
};

// The chip where it is soldered: what the hand that holds the board does to it.
class MotionSensor : public Part {
public:
    virtual void move(const Adxl345::Acceleration& acceleration) = 0;  // from now on
};

}  // namespace sim
