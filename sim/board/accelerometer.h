// accelerometer.h - the board's ADXL345 on the HPS's I2C0, and its INT1 on GPIO61, in time
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <utility>

#include "sim/board/adxl345.h"
#include "sim/board/i2c_speed.h"
#include "sim/pins/pins.h"

#include <systemc>

namespace sim {

class Accelerometer : public sc_core::sc_module, public MotionSensor, public I2cDevices {
public:
    // `interrupt` is called with INT1's level when it has moved; `log` gets what a person should
    // know.
    Accelerometer(const sc_core::sc_module_name& name, std::function<void(bool up)> interrupt,
                  std::function<void(const std::string&)> log)
        : sc_module{name},
          speed_{"ADXL345", 400'000, std::move(log)},
          interrupt_{std::move(interrupt)} {
        SC_HAS_PROCESS(Accelerometer);
        SC_METHOD(sample);
        sensitive << event_;
        dont_initialize();
    }

    void move(const Adxl345::Acceleration& acceleration) override {
        chip_.move(acceleration, now_ps());
        settle();
    }

    bool begin(std::uint8_t address, bool reads, std::uint64_t scl_ps, std::uint64_t) override {
        if (address != Adxl345::ADDRESS || !speed_.answers(scl_ps)) return false;
        chip_.begin(reads);
        settle();
        return true;
    }
    bool write(std::uint8_t byte, std::uint64_t time_ps) override {
        chip_.write(byte, time_ps);
        settle();
        return true;
    }
    std::uint8_t read(std::uint64_t time_ps) override {
        const std::uint8_t byte = chip_.read(time_ps);
        settle();
        return byte;
    }
    void end(std::uint64_t) override {
        chip_.end();
        settle();
    }

    Adxl345& chip() { return chip_; }  // on boards that have it on pins of the FPGA
    // INT1, and when it may move next, after an access by these pins.
    void settle() {
        if (const bool up = chip_.int1(); std::exchange(up_, up) != up) interrupt_(up);
        event_.cancel();
        if (const auto next = chip_.next_ps())
            event_.notify(sc_core::sc_time::from_value(*next > now_ps() ? *next - now_ps() : 0));
    }

private:
    static std::uint64_t now_ps() { return sc_core::sc_time_stamp().value(); }
    void sample() {
        chip_.advance(now_ps());
        settle();
    }

    Adxl345 chip_;
    I2cSpeed speed_;
    bool up_ = false;
    std::function<void(bool)> interrupt_;
    sc_core::sc_event event_;
};

}  // namespace sim
