// de10_lite_devices.h - what the DE10-Lite Computer has in place of the DE1-SoC's: the Arduino
// header's port, the converter of the MAX 10, the accelerometer's SPI
//
//   ArduinoPort        as Intel's PIO, 16 bits, both directions; edges fall
//   Max10Converter     a round of its six channels takes 6 us, 1 us a channel
//   AccelerometerPort  SPI with three wires, 16 bits a transfer, 16 clocks of 100 MHz a bit
//
// The converter: its inputs are halved before its reference of 2.5 V, so that 5 V is the end of its
// 4,096 steps.  A read waits for the round under way, but not while rounds follow each other.
//
// The accelerometer: after a reset the port sets the ADXL345 up with eleven registers, so that it
// measures 50 times a second and reports activity.  A read waits for its transfer; a write only
// for the transfer before it.
//
// Source: "DE10-Lite Computer System with Nios V" (Intel FPGA Academic Program); the Verilog of the
// Accelerometer SPI Mode and ADC Controller cores as others' systems have it; MAX 10 Analog to
// Digital Converter User Guide, "ADC Sampling Rate"; DE10-Lite User Manual, "Arduino Uno R3
// Expansion Header".
//
// Not handled: a value of the converter is that of the moment at which it is read, not of its
// channel's conversion; noise.  How many clocks a bit of the SPI takes is a guess from a parameter.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <functional>

#include "sim/chip/de10_lite_pins.h"

#include <systemc>

namespace sim {

class ArduinoPort {
public:
    // `interrupt` gets the level of its line whenever that is another.
    ArduinoPort(De10LitePins& pins, std::function<void(bool)> interrupt);

    // Offsets 0, 4, 8, 12: data, direction, mask, edges.
    std::uint32_t read(std::uint32_t offset) const;
    void write(std::uint32_t offset, std::uint32_t value);
    // The pins may have moved.
    void look();

private:
    void settle();

    De10LitePins& pins_;
    std::function<void(bool)> interrupt_;
    std::uint16_t data_ = 0, direction_ = 0, mask_ = 0, edges_ = 0, seen_ = 0xFFFF;
    bool up_ = false;
};

class Max10Converter {
public:
    static constexpr unsigned CHANNELS = 6;
    static constexpr std::uint64_t ROUND_PS = CHANNELS * 1'000'000;

    explicit Max10Converter(const PinListener& pins) : pins_{pins} {}

    // When a read of a channel that begins now is answered.
    std::uint64_t answers_ps(std::uint64_t now_ps) const;
    // Channel `offset` / 4, at that time.
    std::uint32_t read(std::uint32_t offset, std::uint64_t now_ps);
    void write(std::uint32_t offset, std::uint32_t value, std::uint64_t now_ps);

private:
    std::uint64_t rounds(std::uint64_t now_ps) const {
        return again_ ? (now_ps - since_ps_) / ROUND_PS : 0;
    }

    const PinListener& pins_;
    bool again_ = false;                              // rounds follow each other
    std::uint64_t since_ps_ = 0, busy_until_ps_ = 0;  // since when they do; of a single round
    std::uint64_t first_ps_ = ~std::uint64_t{0};      // the end of the first round
    std::array<std::uint64_t, CHANNELS> read_{};      // rounds that had ended at the last read
};

class AccelerometerPort : public sc_core::sc_module {
public:
    AccelerometerPort(const sc_core::sc_module_name& name, De10LitePins& pins);

    // Called in a thread of SystemC, in which they may wait.
    std::uint8_t read(unsigned offset);
    void write(unsigned offset, std::uint8_t value);

private:
    struct Transfer {
        std::uint16_t word;
        bool reads;
    };
    void serve();
    void transfer(const Transfer& wanted);
    void wires(bool cs_n, bool sclk, bool sdi);
    void await_idle();

    De10LitePins& pins_;
    std::uint8_t address_ = 0, received_ = 0;
    std::deque<Transfer> wanted_;
    bool sdi_ = true;  // as it is on the wire
    sc_core::sc_event asked_, done_;
};

}  // namespace sim
