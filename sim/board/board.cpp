#include "sim/board/board.h"

#include <utility>

#include "sim/text/seconds.h"

namespace sim {

namespace {

// Bits of hold() and release().
constexpr unsigned ALL_KEYS = 0x0F, HPS_KEY = 0x10;

// Where the keypad's D7 to D0 are: JP1 D7 to D0, unless it is among the parts.
HeaderPinList keypad_pins(const std::vector<PartPlan>& plans) {
    for (const PartPlan& plan : plans)
        if (plan.kind == "keypad") return plan.pins;
    return {9, 8, 7, 6, 5, 4, 3, 1};  // header_bits.h
}

}  // namespace

Board::Board(const sc_core::sc_module_name& name, BoardObserver& observer, std::uint64_t seed,
             Ps2Ports ps2_ports, const ChipMaker& make_chip, Monitor::Strictness vga,
             const std::vector<PartPlan>& part_plans, const UsbPlugs& usb_plugs,
             const BoardShape& shape)
    : sc_module{name},
      observer_{observer},
      has_codec_{shape.on_i2c.count("WM8731") > 0},
      has_decoder_{shape.on_i2c.count("ADV7180") > 0},
      has_hdmi_{shape.on_i2c.count("ADV7513") > 0},
      hears_gsensor_{shape.hears_gsensor},
      has_arduino_{shape.has_arduino},
      monitor{[&observer](const Monitor::Frame& frame) { observer.frame(frame); }, vga,
              [&observer, vga](const std::string& line) {
                  if (vga == Monitor::Strictness::TOLERANT) observer.log("monitor: " + line);
              },
              shape.has_blank},
      codec_chip{
          [this](const StereoSample& sample, std::uint64_t) { hear(sample, codec_chip.rate_hz()); },
          [this] { return line_in.sample(codec_chip.time_ps(), codec_chip.rate_hz()); },
          [this] { return microphone.sample(codec_chip.time_ps(), codec_chip.rate_hz()); }},
      video_decoder{
          [&observer](const std::string& line) { observer.log("video decoder: " + line); }},
      keypad{agenda, seed, [this] { headers_moved(); }},
      switches{agenda, seed, [this] { chip_->inputs().sw = switches.closed(); }},
      ps2_keyboard{agenda, [this] { ps2_wires(chip_->inputs()); }},
      ps2_mouse{agenda, [this] { ps2_wires(chip_->inputs()); }},
      usb{agenda, usb_plugs},
      remote_control{agenda, [this] { chip_->inputs().irda_rxd = remote_control.dark(); }},
      hdmi_transmitter{
          [&observer](const std::string& line) { observer.log("HDMI transmitter: " + line); },
          [this](const StereoSample& sample) { hear(sample, hdmi_transmitter.rate_hz()); }},
      accelerometer{
          "accelerometer", [this](bool up) { chip_->hps_accelerometer_interrupt(up); },
          [&observer](const std::string& line) { observer.log("accelerometer: " + line); }},
      wires{[this](std::uint8_t driven, std::uint8_t enable) {
                return keypad.levels(driven, enable);
            },
            keypad_pins(part_plans), [&observer](const std::string& line) { observer.log(line); }},
      parts{part_plans,
            {agenda, [this](const HeaderMasks& pins, PinLevel level) { wires.part(pins, level); },
             [this] { headers_moved(); }}} {
    const auto plugged = [this](Ps2Plug plug) -> Ps2Device* {
        switch (plug) {
            case Ps2Plug::KEYBOARD: return &ps2_keyboard;
            case Ps2Plug::MOUSE: return &ps2_mouse;
            default: return nullptr;
        }
    };
    ps2_ = {plugged(ps2_ports.first), plugged(ps2_ports.second)};
    for (const auto& [part_name, part] :
         std::initializer_list<std::pair<const char*, Part&>>{{"PS/2 keyboard", ps2_keyboard},
                                                              {"PS/2 mouse", ps2_mouse},
                                                              {"USB keyboard", usb.keyboard},
                                                              {"USB mouse", usb.mouse},
                                                              {"USB ports", usb},
                                                              {"remote control", remote_control},
                                                              {"LINE IN", line_in},
                                                              {"microphone input", microphone},
                                                              {"video decoder", video_decoder},
                                                              {"AD converter", adc_chip},
                                                              {"motion sensor", accelerometer}})
        parts.add(part_name, part);
    if (shape.has_lcd) parts.add("HPS LCD", lcd);
    // The same hands are on USB.
    ps2_keyboard.set_listener([this](std::uint16_t key, bool down) {
        down ? usb.keyboard.press(key) : usb.keyboard.release(key);
    });
    ps2_mouse.set_listener(
        {[this](int right, int up) { usb.mouse.move(right, up); },
         [this](int notches) { usb.mouse.turn(notches); },
         [this](MouseButton which, bool down) { usb.mouse.button(which, down); }});
    chip_ = make_chip(*this, observer, sdram_chip.bytes());
    if (!part_plans.empty()) agenda.at(0, [this] { headers_moved(); });
}

void Board::act(Agenda::Action action) {
    agenda.at(sc_core::sc_time_stamp().value(), std::move(action));
    chip_->catch_up();
}

void Board::video(const std::uint32_t* samples, std::size_t count) {
    constexpr std::uint64_t PATIENCE_PS = 500'000'000'000;
    if (has_hdmi_ && agenda.now_ps() > PATIENCE_PS && !hdmi_transmitter.is_powered() &&
        !std::exchange(warned_, true))
        observer_.log(
            "HDMI transmitter: the design has not powered up the ADV7513 (bit 6 of its register "
            "0x41, by I2C); a board shows this picture only if its SD card's boot loader has");
    monitor.samples(samples, count);
}

// SDAT is open-drain with a pull-up.
void Board::codec(const CodecPins& pins, std::uint64_t time_ps, ChipInputs& in) {
    const auto sdat_level = [&] {
        return !pins.sdat_low && !(has_codec_ && codec_chip.pulls_sda_low()) &&
               !(has_decoder_ && video_decoder.pulls_sda_low()) &&
               !(has_hdmi_ && hdmi_transmitter.pulls_sda_low());
    };
    const auto listen = [&](bool sdat) {
        if (has_codec_)
            codec_chip.drive({pins.bclk, pins.daclrck, pins.adclrck, pins.dacdat, pins.sclk, sdat,
                              pins.clocks_driven},
                             time_ps);
        video_decoder.drive_i2c(pins.sclk, sdat, time_ps);
        hdmi_transmitter.drive_i2c(pins.sclk, sdat, time_ps);
    };
    const bool sdat = sdat_level();
    listen(sdat);
    in.sdat = sdat_level();
    if (in.sdat != sdat) listen(in.sdat);  // what one of them pulls or releases
    if (has_hdmi_) hdmi_transmitter.drive_sound(pins.bclk, pins.daclrck, pins.dacdat, time_ps);
    in.adcdat = codec_chip.adcdat();
    in.codec = codec_chip.clocks();
}

void Board::hear(const StereoSample& sample, double rate_hz) {
    if (rate_hz != rate_hz_) observer_.sample_rate(rate_hz_ = rate_hz);
    observer_.sample(static_cast<std::int16_t>(sample.left >> 16),
                     static_cast<std::int16_t>(sample.right >> 16));
}

void Board::xck(std::uint64_t period_fs, std::uint64_t, ChipInputs& in) {
    if (has_codec_) codec_chip.xck(period_fs);
    in.codec = codec_chip.clocks();
}

void Board::bclk_edge(std::uint64_t, ChipInputs& in) {
    codec_chip.bclk_edge();
    in.codec = codec_chip.clocks();
}

// ---- Headers ----

void Board::headers(const HeaderPins& pins, std::uint64_t time_ps, ChipInputs& in) {
    agenda.pass_to(time_ps);
    wires.fpga(pins);
    header_wires(in, time_ps);
}

void Board::header_wires(ChipInputs& in, std::uint64_t time_ps) {
    in.gpio = wires.settle();
    parts.look(in.gpio, time_ps);
    for (unsigned n = 0; n < HEADERS; ++n) lamps_.gpio[n] = {in.gpio[n], wires.outputs(n)};
    observer_.lamps(lamps_, seconds(time_ps));
}

void Board::headers_moved() { header_wires(chip_->inputs(), agenda.now_ps()); }

void Board::drive_pins(const HeaderMasks& pins, PinLevel level) {
    act([this, pins, level] {
        wires.hand(pins, level);
        headers_moved();
    });
}

// ---- Lamps ----

void Board::lamps(const LampPins& pins, std::uint64_t time_ps) {
    eyes_.pass(time_ps);
    light(0, pins.ledr, lit_.leds);
    light(HEX_FIRST, pins.hex_n ^ ALL_SEGMENTS, lit_.hex);
    eyes_.show();
}

void Board::hps_led(bool lit, std::uint64_t time_ps) {
    eyes_.pass(time_ps);
    light(HPS_LED_NUMBER, lit, lit_.hps_led);
    eyes_.show();
}

// Those from number `first` on.
void Board::light(unsigned first, std::uint64_t lit, std::uint64_t& was) {
    for (std::uint64_t moved = lit ^ was; moved; moved &= moved - 1) {
        const auto lamp = static_cast<unsigned>(__builtin_ctzll(moved));
        eyes_.light(first + lamp, lit >> lamp & 1);
    }
    was = lit;
}

void Board::see(std::uint64_t time_ps) {
    const auto seen = [this](unsigned first, unsigned count) {
        std::uint64_t lit = 0;
        for (unsigned n = 0; n < count; ++n) lit |= std::uint64_t{eyes_.seen(first + n)} << n;
        return lit;
    };
    lamps_.ledr = static_cast<std::uint32_t>(seen(0, LEDS));
    lamps_.hex = seen(HEX_FIRST, 8 * DIGITS);
    lamps_.hps_led = eyes_.seen(HPS_LED_NUMBER);
    observer_.lamps(lamps_, seconds(time_ps));
}

const Lamps& Board::lamps() {
    eyes_.pass(sc_core::sc_time_stamp().value());
    return lamps_;
}

void Board::settle_lamps() { eyes_.pass(chip_->time_ps()); }

void Board::adc(const AdcPins& pins, std::uint64_t time_ps, ChipInputs& in) {
    adc_chip.drive(pins.convst, pins.sck, pins.sdi, time_ps);
    in.adc_sdo = adc_chip.sdo();
}

void Board::gsensor(const GsensorPins& pins, std::uint64_t time_ps, ChipInputs& in) {
    accelerometer_wires.drive(pins, time_ps);
    in.gsensor_sdi = !accelerometer_wires.pulls_sdi_low();
    in.gsensor_sdo = !accelerometer_wires.pulls_sdo_low();
    if (hears_gsensor_ && pins.cs_n) accelerometer.settle();
}

void Board::sdram(const SdramPins& pins, std::uint64_t time_ps, std::uint16_t& dq, bool& more) {
    sdram_chip.clock({pins.cs_n, pins.ras_n, pins.cas_n, pins.we_n, pins.ba, pins.addr, pins.dqm,
                      pins.dq_driven, pins.dq, pins.cke},
                     time_ps);
    dq = sdram_chip.dq();
    more = sdram_chip.busy();
}

void Board::ps2(unsigned clk_low, unsigned dat_low, std::uint64_t time_ps, ChipInputs& in) {
    agenda.pass_to(time_ps);
    ps2_clk_low_ = clk_low;
    ps2_dat_low_ = dat_low;
    for (unsigned port = 0; port < ps2_.size(); ++port)
        if (ps2_[port]) ps2_[port]->host(clk_low >> port & 1, dat_low >> port & 1);
    ps2_wires(in);
}

// Open collectors with pull-ups.
void Board::ps2_wires(ChipInputs& in) const {
    unsigned clk_low = ps2_clk_low_, dat_low = ps2_dat_low_;
    for (unsigned port = 0; port < ps2_.size(); ++port) {
        if (!ps2_[port]) continue;
        clk_low |= unsigned{ps2_[port]->clk_low()} << port;
        dat_low |= unsigned{ps2_[port]->dat_low()} << port;
    }
    in.ps2_clk = static_cast<std::uint8_t>(3 & ~clk_low);
    in.ps2_dat = static_cast<std::uint8_t>(3 & ~dat_low);
}

namespace {

BouncingContacts::Bounce bounce_now(std::uint64_t within_ps) {
    return {2, sc_core::sc_time_stamp() == sc_core::SC_ZERO_TIME ? 0 : within_ps / 1000};
}

}  // namespace

void Board::hold(std::uint16_t keys16, std::uint8_t keys, std::uint32_t slid,
                 std::uint64_t bounce_ps) {
    act([this, keys16, keys, slid, bounce = bounce_now(bounce_ps)] {
        if (keys16) keypad.press(keys16);
        ChipInputs& in = chip_->inputs();
        in.key_n = static_cast<std::uint8_t>(in.key_n & ~keys);
        if (slid) switches.move(slid, true, bounce);
    });
    if (keys & HPS_KEY) chip_->hps_key(true);
}

void Board::release(std::uint16_t keys16, std::uint8_t keys, std::uint32_t slid,
                    std::uint64_t bounce_ps) {
    act([this, keys16, keys, slid, bounce = bounce_now(bounce_ps)] {
        if (keys16) keypad.release(keys16);
        ChipInputs& in = chip_->inputs();
        in.key_n = static_cast<std::uint8_t>(in.key_n | (keys & ALL_KEYS));
        if (slid) switches.move(slid, false, bounce);
    });
    if (keys & HPS_KEY) chip_->hps_key(false);
}

}  // namespace sim
