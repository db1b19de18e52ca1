#include "sim/chip/de10_lite_pins.h"

#include <utility>

#include "sim/pins/header_pin.h"

namespace sim {

namespace {

constexpr std::uint32_t UPPER_HALVES = ~std::uint32_t{0x0F0F0F};  // the upper half of each colour
constexpr unsigned ARDUINO = header_of(ChipWire::ARDUINO_IO);

}  // namespace

De10LitePins::De10LitePins(PinListener& board) : board_{board} {
    board_.agenda.on_next([this](std::uint64_t next_ps) {
        if (next_) agenda.cancel(*next_);
        next_.reset();
        if (next_ps == Agenda::NEVER) return;
        next_ = agenda.at(next_ps, [this, next_ps] {
            next_.reset();
            board_.agenda.run_to(next_ps);
            moved_();
        });
    });
}

De10LitePins::~De10LitePins() {
    board_.agenda.on_next([](std::uint64_t) {});
}

void De10LitePins::connect(ChipInputs& inputs, std::function<void()> moved) {
    inputs_ = &inputs;
    moved_ = std::move(moved);
}

HeaderPins De10LitePins::with_arduino() const {
    HeaderPins pins{};
    pins.levels[0] = fabric_.levels[0];
    pins.enable[0] = fabric_.enable[0];
    pins.levels[ARDUINO] = levels_;
    pins.enable[ARDUINO] = enable_;
    return pins;
}

void De10LitePins::drive_arduino(std::uint16_t levels, std::uint16_t enable) {
    levels_ = levels;
    enable_ = enable;
    board_.headers(with_arduino(), agenda.now_ps(), *inputs_);
    moved_();
}

std::uint16_t De10LitePins::arduino() const {
    return static_cast<std::uint16_t>(inputs_->gpio[ARDUINO] & pins_of(ChipWire::ARDUINO_IO));
}

bool De10LitePins::drive_gsensor(const GsensorPins& pins, std::uint64_t time_ps) {
    board_.gsensor(pins, time_ps, sensor_);
    return sensor_.gsensor_sdi;
}

void De10LitePins::video(const std::uint32_t* samples, std::size_t count) {
    on_samples_(count);
    samples_.assign(samples, samples + count);
    for (std::uint32_t& sample : samples_) sample &= UPPER_HALVES;
    board_.video(samples_.data(), count);
}

void De10LitePins::headers(const HeaderPins& pins, std::uint64_t time_ps, ChipInputs& in) {
    fabric_ = pins;
    board_.headers(with_arduino(), time_ps, in);
    moved_();
}

}  // namespace sim
