#include "sim/board/wm8731.h"

#include <utility>

#include <fmt/format.h>

namespace sim {

namespace {

constexpr std::uint8_t ADDRESS = 0x1a;
constexpr std::uint64_t SETUP_PS = 10'000, HOLD_PS = 10'000;  // t_DS, t_DH, t_LRSU, t_LRH
constexpr std::size_t CODEC_MESSAGES = 20;

constexpr unsigned LEFT_IN = 0, RIGHT_IN = 1, RIGHT_OUT = 3, ANALOGUE = 4, DIGITAL = 5,
                   POWER_DOWN = 6, INTERFACE = 7, SAMPLING = 8, CONTROL = 9, RESET = 15;
constexpr std::array<std::uint16_t, Wm8731::REGISTERS> DEFAULTS{0x097, 0x097, 0x079, 0x079, 0x00a,
                                                                0x008, 0x09f, 0x00a, 0x000, 0x000};

constexpr unsigned BOTH = 1u << 8;                                        // R0 - R3
constexpr unsigned LINMUTE = 1u << 7;                                     // R0, R1
constexpr unsigned MUTEMIC = 1u << 1, INSEL = 1u << 2, DACSEL = 1u << 4;  // R4
constexpr unsigned DACMU = 1u << 3;                                       // R5
constexpr unsigned LINEINPD = 1u << 0, MICPD = 1u << 1, ADCPD = 1u << 2, DACPD = 1u << 3,
                   OUTPD = 1u << 4,
                   POWEROFF = 1u << 7;                                                // R6
constexpr unsigned LRP = 1u << 4, LRSWAP = 1u << 5, MS = 1u << 6, BCLKINV = 1u << 7;  // R7
constexpr unsigned ACTIVE = 1u << 0;                                                  // R9

const std::string CONTENTION = "R7: the codec is bus master, but the FPGA drives BCLK or LRCK, too";

AudioFormat format_of(unsigned r7) {
    constexpr unsigned BITS[] = {16, 20, 24, 32};
    AudioFormat format{static_cast<AudioFormat::Framing>(r7 & 3), BITS[r7 >> 2 & 3],
                       (r7 & LRP) != 0};
    if (format.framing == AudioFormat::RIGHT && format.bits == 32)
        format.bits = 24;  // an error reports it
    return format;
}

// The filters work with 24 bits.
StereoSample top_24_bits(const StereoSample& sample) {
    return {sample.left & ~0xff, sample.right & ~0xff};
}

}  // namespace

Wm8731::Wm8731(Sink sink, Source line_in, Source microphone)
    : sink_{std::move(sink)},
      line_in_{std::move(line_in)},
      microphone_{std::move(microphone)},
      control_{[this](unsigned number, std::uint8_t value) { return byte(number, value); },
               [this](unsigned bytes, unsigned bits) { end_of_transfer(bytes, bits); }},
      adc_{[this] { return input(); }},
      registers_{DEFAULTS} {
    apply();
}

void Wm8731::drive(const Pins& pins, std::uint64_t time_ps) {
    const Pins was = std::exchange(pins_, pins);
    now_ps_ = time_ps;
    if (pins.sclk != was.sclk || pins.sda != was.sda) control_.drive(pins.sclk, pins.sda, time_ps);

    const bool clocked = pins.bclk != was.bclk, sampling = clocked && pins.bclk != inverted_;
    bclk_moved_ |= clocked;
    dacdat_moved_ |= pins.dacdat != was.dacdat;
    if (clocks_.driven && pins.clocks_driven && reported_.count(CONTENTION) == 0) error(CONTENTION);
    if (active_ && !clocks_.driven) check_timing(was, sampling);
    if (pins.daclrck != was.daclrck || pins.dacdat != was.dacdat) moved_ps_ = time_ps;
    if (pins.adclrck != was.adclrck) adc_.lrck(pins.adclrck);
    if (sampling) {
        sampled_ps_ = time_ps;
        adc_.sampled();
        // What others move with BCLK's edge comes after it.
        const bool lrck = clocks_.driven ? pins.daclrck : was.daclrck;
        if (const auto ended = dac_.sample(lrck, was.dacdat)) frame(*ended);
    } else if (pins.bclk == inverted_ && (clocked || pins.adclrck != was.adclrck)) {
        adcdat_ = adc_.bit();
    }
}

void Wm8731::check_timing(const Pins& was, bool sampling) {
    const bool lrck_moves = pins_.daclrck != was.daclrck;
    const bool moves = lrck_moves || pins_.dacdat != was.dacdat;
    if (sampling ? moves || now_ps_ - moved_ps_ < SETUP_PS
                 : moves && now_ps_ - sampled_ps_ < HOLD_PS)
        error("DACDAT or DACLRCK moves within 10 ns of the BCLK edge that samples it");
    if ((lrck_moves || pins_.adclrck != was.adclrck) && pins_.bclk != inverted_ && !sampling)
        error("LRCK moves where BCLK does not fall");
}

// ---- Control ----------------------------------------------------------------

bool Wm8731::byte(unsigned number, std::uint8_t value) {
    switch (number) {
        case 0:
            if (value >> 1 != ADDRESS) return false;  // another device is addressed
            ++words_;
            if (!speed_.answers(control_.shortest_ps())) {
                ++refused_words_;
                return false;
            }
            if (value & 1) return refuse("I2C: a read, but the chip is write-only");
            if (words_ != refuse_word_) return true;
            ++refused_words_;
            return false;
        case 1:
            first_byte_ = value;
            if (value >> 1 < REGISTERS || value >> 1 == RESET) return true;
            return refuse(fmt::format("I2C: register {} does not exist", value >> 1));
        case 2:
            write(first_byte_ >> 1, static_cast<std::uint16_t>((first_byte_ & 1) << 8 | value));
            return true;
        default: return refuse("I2C: more than two bytes in a word");
    }
}

bool Wm8731::refuse(const std::string& why) {
    ++refused_words_;
    error(why);
    return false;
}

void Wm8731::end_of_transfer(unsigned bytes, unsigned bits) {
    if (bytes == 0 || (bytes == 3 && bits == 0)) return;  // for another device, or complete
    error(fmt::format("I2C: a word ends after {} bytes and {} bits", bytes, bits));
}

void Wm8731::write(unsigned number, std::uint16_t value) {
    if (number == RESET) {
        if (value == 0) registers_ = DEFAULTS;
    } else {
        registers_[number] = value;
        if (number <= RIGHT_OUT && value & BOTH) registers_[number ^ 1] = value & 0xff;
    }
    apply();
}

void Wm8731::apply() {
    const unsigned r7 = registers_[INTERFACE];
    const AudioFormat format = format_of(r7);
    inverted_ = (r7 & BCLKINV) != 0;
    swapped_ = (r7 & LRSWAP) != 0;
    if (format.framing != format_.framing || format.bits != format_.bits ||
        format.lrp != format_.lrp) {
        format_ = format;
        dac_.format(format);
        adc_.format(format);
    }
    active_ = (registers_[CONTROL] & ACTIVE) != 0;
    was_active_ |= active_;
    audible_ = active_ && !(registers_[POWER_DOWN] & (DACPD | OUTPD | POWEROFF)) &&
               !(registers_[DIGITAL] & DACMU) && registers_[ANALOGUE] & DACSEL;
    apply_clocks();
}

void Wm8731::apply_clocks() {
    const Wm8731Rates rates = wm8731_rates(registers_[SAMPLING]);
    generator_.rates(rates);
    clocks_.driven = (registers_[INTERFACE] & MS) != 0;
    const bool run = clocks_.driven && active_ && !(registers_[POWER_DOWN] & POWEROFF);
    if (run && !rates.listed)
        error(fmt::format("R8 = 0x{:03x}: not a rate of the datasheet's", registers_[SAMPLING]));
    clocks_.bclk_half_fs = run ? xck_fs_ * rates.xcks / 2 : 0;
}

void Wm8731::xck(std::uint64_t period_fs) {
    xck_fs_ = period_fs;
    xck_moved_ |= period_fs != 0;
    apply_clocks();
}

void Wm8731::bclk_edge() {
    generator_.edge(inverted_);
    clocks_.bclk = generator_.bclk();
    clocks_.daclrck = generator_.daclrck();
    clocks_.adclrck = generator_.adclrck();
}

// ---- Sound ------------------------------------------------------------------

void Wm8731::frame(const AudioReceiver::Frame& frame) {
    const bool first = frame_ps_ == 0;
    if (!first) measure_rate();
    frame_ps_ = now_ps_;
    if (first) return;  // it began before the first sample
    if (active_ && frame.whole && frame.least_bclks < format_.least_bclks())
        error(fmt::format("DACDAT: slots of {} BCLKs for words of {} bits", frame.least_bclks,
                          format_.bits));
    ++samples_;
    was_audible_ |= audible_;
    if (!sink_) return;
    StereoSample sample;
    if (audible_) sample = top_24_bits(frame.sample);
    if (swapped_) std::swap(sample.left, sample.right);
    sink_(sample, now_ps_);
}

void Wm8731::measure_rate() {
    const std::uint64_t period = now_ps_ - frame_ps_;
    if (within_1_percent(period, last_period_ps_) && !within_1_percent(period, period_ps_))
        period_ps_ = period;
    last_period_ps_ = period;
}

double Wm8731::rate_hz() const { return period_ps_ ? 1e12 / static_cast<double>(period_ps_) : 0.0; }

StereoSample Wm8731::input() {
    const bool from_microphone = (registers_[ANALOGUE] & INSEL) != 0;
    const Source& source = from_microphone ? microphone_ : line_in_;
    const unsigned off = ADCPD | POWEROFF | (from_microphone ? MICPD : LINEINPD);
    StereoSample sample;
    if (source) sample = top_24_bits(source());
    if (from_microphone) sample.right = sample.left;
    if (!active_ || registers_[POWER_DOWN] & off) return {};
    if (from_microphone) return registers_[ANALOGUE] & MUTEMIC ? StereoSample{} : sample;
    if (registers_[LEFT_IN] & LINMUTE) sample.left = 0;
    if (registers_[RIGHT_IN] & LINMUTE) sample.right = 0;
    return sample;
}

std::string Wm8731::silence() const {
    if (was_audible_ || !(was_active_ || dacdat_moved_ || xck_moved_)) return {};
    if (!was_active_) return "silent: it was never activated over I2C (R9 = 1)";
    if (!bclk_moved_ && !clocks_.driven)
        return "silent: it is a slave (R7), and nothing drives BCLK";
    if (!bclk_moved_) return "silent: it is bus master (R7), but XCK stands still";
    return fmt::format(
        "silent: muted or off, by R4 = 0x{:03x}, R5 = 0x{:03x}, R6 = 0x{:03x}, R9 = {}, or LRCK "
        "stands still",
        registers_[ANALOGUE], registers_[DIGITAL], registers_[POWER_DOWN], registers_[CONTROL]);
}

void Wm8731::error(const std::string& text) {
    ++error_count_;
    if (errors_.size() < CODEC_MESSAGES && reported_.insert(text).second)
        errors_.push_back(fmt::format("{}.{:09} s: {}", now_ps_ / 1'000'000'000'000,
                                      now_ps_ / 1'000 % 1'000'000'000, text));
}

}  // namespace sim
