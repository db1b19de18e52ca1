#include "sim/board/adv7513.h"

#include <fmt/format.h>

namespace sim {

Adv7513::Adv7513(std::function<void(const std::string&)> log, Sink sink)
    : log_{std::move(log)}, sink_{std::move(sink)}, speed_{"ADV7513", 400'000, log_} {
    registers_[0x00] = 0x13;  // the chip's revision
    registers_[SOURCE] = 0x01;
    registers_[CLOCK] = 0x0E;
    registers_[I2S] = 0xBC;
    registers_[WIDTH] = 0x18;
    registers_[POWER] = POWER_DOWN | 0x10;
    registers_[0x42] = 0x70;
    registers_[PACKETS] = 0x79;
    registers_[MODE] = 0x14;
    registers_[0xF5] = 0x75;  // the chip's number
    registers_[0xF6] = 0x11;
    apply();
}

bool Adv7513::is_read_only(unsigned number) {
    return number == 0x00 || number == 0x42 || number == 0xF5 || number == 0xF6;
}

bool Adv7513::is_powered() const { return !(registers_[POWER] & POWER_DOWN); }

bool Adv7513::byte(unsigned number, std::uint8_t value) {
    if (number == 0) return value >> 1 == ADDRESS && speed_.answers(control_.shortest_ps());
    if (number == 1) {
        pointer_ = value;
    } else if (const std::uint8_t at = pointer_++; !is_read_only(at)) {
        registers_[at] = value;
        if (at == I2S || at == WIDTH) apply();
    }
    return true;
}

void Adv7513::apply() {
    constexpr unsigned LONGEST = 24;
    switch (registers_[I2S] & FORMAT_MASK) {
        case RIGHT: return receiver_.format({AudioFormat::RIGHT, registers_[WIDTH] & WIDTH_MASK});
        case LEFT: return receiver_.format({AudioFormat::LEFT, LONGEST});
        default: return receiver_.format({AudioFormat::I2S, LONGEST});
    }
}

unsigned Adv7513::n() const {
    return (registers_[N_HIGH] & 0xFu) << 16 | unsigned{registers_[N_HIGH + 1]} << 8 |
           registers_[N_HIGH + 2];
}

const char* Adv7513::why_silent() const {
    if (!is_powered()) return "it is powered down (bit 6 of 0x41)";
    if (!(registers_[MODE] & HDMI)) return "DVI has no sound: expected HDMI (bit 1 of 0xAF)";
    if ((registers_[PACKETS] & SOUND_AND_N) != SOUND_AND_N)
        return "it sends no sound or no N (bits 5 and 6 of 0x44)";
    if (registers_[SOURCE] & SOURCE_MASK) return "its sound is not from I2S (bits 6:4 of 0x0A)";
    if (!(registers_[I2S] & I2S0_ON)) return "its input I2S0 is off (bit 2 of 0x0C)";
    if ((registers_[I2S] & FORMAT_MASK) == AES3)
        return "AES3 in I2S is not simulated (bits 1:0 of 0x0C)";
    if ((registers_[I2S] & FORMAT_MASK) == RIGHT && !(registers_[WIDTH] & WIDTH_MASK))
        return "its words have no bits (0x0D)";
    if (n() == 0) return "N is 0 (0x01 to 0x03): expected 6144 at 48 kHz";
    return nullptr;
}

std::string Adv7513::silence() const {
    if (was_heard_ || !data_moved_) return {};
    const char* const why = why_silent();
    return fmt::format("silent: {}", why ? why : "SCLK or LRCLK stands still");
}

void Adv7513::drive_sound(bool sclk, bool lrclk, bool data, std::uint64_t time_ps) {
    data_moved_ |= std::exchange(data_, data) != data;
    if (std::exchange(sclk_, sclk) == sclk) return;
    const bool falls = (registers_[CLOCK] & SCLK_FALLS) != 0;
    if (sclk == falls) return;
    if (const auto ended = receiver_.sample(lrclk, data)) frame(*ended, time_ps);
}

void Adv7513::frame(const AudioReceiver::Frame& frame, std::uint64_t time_ps) {
    const std::uint64_t before = std::exchange(frame_ps_, time_ps);
    if (before == 0) return;  // it began before the first sample
    const std::uint64_t period = time_ps - before;
    if (within_1_percent(period, last_period_ps_) && !within_1_percent(period, period_ps_))
        period_ps_ = period;
    last_period_ps_ = period;
    const bool heard = !why_silent();
    was_heard_ |= heard;
    // HDMI: 128 rate / 1500 Hz to 128 rate / 300 Hz.
    const double least = rate_hz() * 128 / 1500, most = rate_hz() * 128 / 300;
    if (heard && period_ps_ && !std::exchange(judged_n_, true) && (n() < least || n() > most))
        log_(fmt::format("N is {} (0x01 to 0x03): HDMI has {:.0f} to {:.0f} at {:.0f} Hz", n(),
                         least, most, rate_hz()));
    if (sink_) sink_(heard ? frame.sample : StereoSample{});
}

}  // namespace sim
