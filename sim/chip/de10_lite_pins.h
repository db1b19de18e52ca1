// de10_lite_pins.h - between the fabric and a DE10-Lite: what that board's pins do otherwise
//
//   fabric --- De10LitePins --- board
//
// VGA has 4 bits a colour.  There is no JP2; the Arduino header, ARDUINO_IO, is driven by a block
// of its own.  Nothing hangs on I2C, and there are no PS/2 ports and no converter
// on pins.
//
// The board enters what it does into its own agenda; here is an entry for the next of them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "sim/pins/pins.h"

namespace sim {

class De10LitePins : public PinListener {
public:
    explicit De10LitePins(PinListener& board);
    ~De10LitePins();
    De10LitePins(const De10LitePins&) = delete;
    De10LitePins& operator=(const De10LitePins&) = delete;

    // The chip's inputs, once it is there; `moved` is called after the Arduino header may have
    // moved.
    void connect(ChipInputs& inputs, std::function<void()> moved);
    // Calls with so many samples of the picture, before the board gets them.
    void on_samples(std::function<void(std::size_t)> on_samples) {
        on_samples_ = std::move(on_samples);
    }

    // From now on the chip drives these of the Arduino header's 16 pins, with these levels.
    void drive_arduino(std::uint16_t levels, std::uint16_t enable);
    std::uint16_t arduino() const;  // as the pins are

    // The accelerometer's wires, now; returns SDI as the sensor has it.
    bool drive_gsensor(const GsensorPins& pins, std::uint64_t time_ps);

    void video(const std::uint32_t* samples, std::size_t count) override;
    void video_clock(std::uint64_t period_ps) override { board_.video_clock(period_ps); }
    void video_idle(std::uint64_t time_ps) override { board_.video_idle(time_ps); }
    void codec(const CodecPins&, std::uint64_t, ChipInputs&) override {}
    void headers(const HeaderPins& pins, std::uint64_t time_ps, ChipInputs& in) override;
    void lamps(const LampPins& pins, std::uint64_t time_ps) override {
        board_.lamps(pins, time_ps);
    }
    void adc(const AdcPins&, std::uint64_t, ChipInputs&) override {}
    int analog_mv(unsigned input) const override { return board_.analog_mv(input); }
    void sdram(const SdramPins& pins, std::uint64_t time_ps, std::uint16_t& dq,
               bool& more) override {
        board_.sdram(pins, time_ps, dq, more);
    }
    void ps2(unsigned, unsigned, std::uint64_t, ChipInputs&) override {}
    std::uint8_t td_data(std::uint64_t rise) override { return board_.td_data(rise); }

private:
    HeaderPins with_arduino() const;

    PinListener& board_;
    std::optional<Agenda::Entry> next_;  // of the board's agenda, in this one
    ChipInputs* inputs_ = nullptr;
    ChipInputs sensor_;
    std::function<void()> moved_ = [] {};
    std::function<void(std::size_t)> on_samples_ = [](std::size_t) {};
    HeaderPins fabric_{};
    std::uint16_t levels_ = 0, enable_ = 0;
    std::vector<std::uint32_t> samples_;
};

}  // namespace sim
