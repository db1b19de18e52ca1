#include "sim/board/adxl345.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace sim {

namespace {

enum Register : std::uint8_t {
    DEVID = 0x00,
    THRESH_TAP = 0x1D,
    OFSX = 0x1E,
    THRESH_ACT = 0x24,
    THRESH_INACT = 0x25,
    TIME_INACT = 0x26,
    ACT_INACT_CTL = 0x27,
    THRESH_FF = 0x28,
    TIME_FF = 0x29,
    ACT_TAP_STATUS = 0x2B,
    BW_RATE = 0x2C,
    POWER_CTL = 0x2D,
    INT_ENABLE = 0x2E,
    INT_MAP = 0x2F,
    INT_SOURCE = 0x30,
    DATA_FORMAT = 0x31,
    DATAX0 = 0x32,
    DATAZ1 = 0x37,
    FIFO_CTL = 0x38,
    FIFO_STATUS = 0x39
};

constexpr std::uint8_t IDENTITY = 0xE5, HZ_100 = 0x0A;
constexpr std::uint8_t DATA_READY = 0x80, ACTIVITY = 0x10, INACTIVITY = 0x08, FREE_FALL = 0x04,
                       WATERMARK = 0x02, OVERRUN = 0x01;
constexpr std::uint8_t MEASURE = 0x08, SLEEP = 0x04, FULL_RES = 0x08, JUSTIFY = 0x04,
                       INT_INVERT = 0x20;
constexpr unsigned BYPASS = 0, FIFO = 1, DEPTH = 32;
constexpr std::uint64_t PS_PER_S = 1'000'000'000'000, FASTEST_PS = PS_PER_S / 3200;
constexpr double G_PER_OFFSET = 0.0156, G_PER_THRESHOLD = 0.0625;
constexpr unsigned LSB_PER_G = 256;  // of 10 bits and +-2 g

}  // namespace

Adxl345::Adxl345() { registers_[BW_RATE] = HZ_100; }

void Adxl345::move(const Acceleration& acceleration, std::uint64_t now_ps) {
    advance(now_ps);
    acceleration_ = acceleration;
}

// ---- Samples ----

bool Adxl345::measures() const { return registers_[POWER_CTL] & MEASURE; }

std::uint64_t Adxl345::period_ps() const {
    if (registers_[POWER_CTL] & SLEEP) return PS_PER_S / (8u >> (registers_[POWER_CTL] & 3));
    return FASTEST_PS << (0xF - (registers_[BW_RATE] & 0xF));
}

std::optional<std::uint64_t> Adxl345::next_ps() const {
    if (!measures() || registers_[INT_ENABLE] == 0) return {};
    return last_ps_ + period_ps();
}

void Adxl345::advance(std::uint64_t now_ps) {
    if (!measures()) return;
    const std::uint64_t period = period_ps();
    while (now_ps >= last_ps_ + period) {
        // A long time of the same samples: those that neither fill the FIFO nor end a time limit.
        const std::uint64_t left = (now_ps - last_ps_) / period;
        constexpr std::uint64_t MOST = 1'000'000;
        if (left > MOST) last_ps_ += (left - MOST) * period;
        last_ps_ += period;
        measure();
    }
}

Adxl345::Sample Adxl345::measured() const {
    const unsigned range = registers_[DATA_FORMAT] & 3;
    const bool full = registers_[DATA_FORMAT] & FULL_RES;
    const unsigned bits = full ? 10 + range : 10;
    const double per_g = full ? LSB_PER_G : LSB_PER_G >> range;
    const double axes[] = {acceleration_.x, acceleration_.y, acceleration_.z};
    Sample sample;
    for (unsigned i = 0; i < 3; ++i) {
        const auto offset = static_cast<std::int8_t>(registers_[OFSX + i]);
        const double counts = std::round((axes[i] + offset * G_PER_OFFSET) * per_g);
        const double most = static_cast<double>(1u << (bits - 1));
        const int value = static_cast<int>(std::clamp(counts, -most, most - 1));
        const bool left = registers_[DATA_FORMAT] & JUSTIFY;
        sample[i] = static_cast<std::int16_t>(left ? value * (1 << (16 - bits)) : value);
    }
    return sample;
}

void Adxl345::measure() {
    const Sample sample = measured();
    const unsigned mode = registers_[FIFO_CTL] >> 6;
    if (mode == BYPASS) {
        overrun_ |= fresh_;
        data_ = sample;
        fresh_ = true;
    } else if (!fresh_ && fifo_.empty()) {
        data_ = sample;
        fresh_ = true;
    } else if (fifo_.size() < DEPTH) {
        fifo_.push_back(sample);
    } else {
        overrun_ = true;
        if (mode != FIFO) {  // a stream drops the oldest
            data_ = fifo_.front();
            fifo_.pop_front();
            fifo_.push_back(sample);
        }
    }
    judge();
}

// Activity, inactivity, free fall: of each sample, with what came before.
void Adxl345::judge() {
    const double now[] = {acceleration_.x, acceleration_.y, acceleration_.z};
    const double was[] = {reference_.x, reference_.y, reference_.z};
    const std::uint8_t control = registers_[ACT_INACT_CTL];
    const auto threshold = [this](std::uint8_t number) {
        return registers_[number] * G_PER_THRESHOLD;
    };
    bool moves = false, is_still = control & 7, falls = true;
    for (unsigned i = 0; i < 3; ++i) {
        const double acts = std::abs(now[i] - (control & 0x80 ? was[i] : 0));
        const double rests = std::abs(now[i] - (control & 0x08 ? was[i] : 0));
        if (control & (0x40 >> i)) moves |= acts > threshold(THRESH_ACT);
        if (control & (0x04 >> i)) is_still &= rests < threshold(THRESH_INACT);
        falls &= std::abs(now[i]) < threshold(THRESH_FF);
    }
    still_ps_ = is_still ? still_ps_ + period_ps() : 0;
    falls_ps_ = falls ? falls_ps_ + period_ps() : 0;
    if (moves) events_ |= ACTIVITY;
    if (is_still && still_ps_ >= registers_[TIME_INACT] * PS_PER_S) events_ |= INACTIVITY;
    if (falls && falls_ps_ >= registers_[TIME_FF] * (PS_PER_S / 200)) events_ |= FREE_FALL;
    if (moves || (events_ & INACTIVITY)) reference_ = acceleration_;
}

void Adxl345::pop() {
    fresh_ = overrun_ = false;
    if (fifo_.empty()) return;
    data_ = fifo_.front();
    fifo_.pop_front();
    fresh_ = true;
}

// ---- Registers ----

std::uint8_t Adxl345::get(std::uint8_t number) const {
    const std::size_t entries = fifo_.size() + fresh_;
    switch (number) {
        case DEVID: return IDENTITY;
        case INT_SOURCE:
            return static_cast<std::uint8_t>(
                (fresh_ ? DATA_READY : 0) | events_ | (overrun_ ? OVERRUN : 0) |
                (entries >= (registers_[FIFO_CTL] & 0x1Fu) ? WATERMARK : 0));
        case FIFO_STATUS:
            return static_cast<std::uint8_t>(registers_[FIFO_CTL] >> 6 == BYPASS ? 0 : entries);
        default: break;
    }
    if (number >= DATAX0 && number <= DATAZ1) {
        const unsigned i = number - DATAX0;
        return static_cast<std::uint8_t>(static_cast<std::uint16_t>(data_[i / 2]) >> (i % 2 * 8));
    }
    return number < registers_.size() ? registers_[number] : 0;
}

void Adxl345::set(std::uint8_t number, std::uint8_t value, std::uint64_t now_ps) {
    const bool read_only = number < THRESH_TAP || number == ACT_TAP_STATUS ||
                           number == INT_SOURCE || (number >= DATAX0 && number <= DATAZ1) ||
                           number >= FIFO_STATUS;
    if (read_only) return;
    const bool measured_before = measures();
    registers_[number] = value;
    if (number == POWER_CTL && measures() && !measured_before) {
        last_ps_ = now_ps;
        reference_ = acceleration_;
        still_ps_ = falls_ps_ = 0;
    }
    if (number == BW_RATE) last_ps_ = now_ps;
    if (number == FIFO_CTL && value >> 6 == BYPASS) fifo_.clear();
}

void Adxl345::begin(bool reads) {
    end();
    register_next_ = !reads;
}

void Adxl345::end() {
    if (std::exchange(data_read_, false)) pop();
}

void Adxl345::write(std::uint8_t byte, std::uint64_t now_ps) {
    advance(now_ps);
    if (register_next_)
        pointer_ = byte & 0x3F;
    else
        set(pointer_++, byte, now_ps);
    register_next_ = false;
}

std::uint8_t Adxl345::read(std::uint64_t now_ps) {
    advance(now_ps);
    const std::uint8_t number = pointer_++, value = get(number);
    if (number == INT_SOURCE) events_ = 0;
    if (number >= DATAX0 && number <= DATAZ1) data_read_ = true;
    return value;
}

bool Adxl345::int1() const {
    const std::uint8_t asserted =
        static_cast<std::uint8_t>(get(INT_SOURCE) & registers_[INT_ENABLE] & ~registers_[INT_MAP]);
    return (asserted != 0) != ((registers_[DATA_FORMAT] & INT_INVERT) != 0);
}

}  // namespace sim
