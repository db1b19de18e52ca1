// board.h - the schematic: what hangs on the chip's pins, and the hands at the board.
//
//   Chip --pins--+- Monitor   (VGA)
//                +- Wm8731    (audio)  <-- SoundSource
//                +- Adv7180   (video in)
//                +- Adv7513   (HDMI, of boards that have it in place of VGA)
//                +- Ltc2308   (AD converter)
//                +- Is42s16320d  (SDRAM)
//                +- Keypad    (JP1 D7-D0, or where the scenario hangs it)
//                +- Ps2Keyboard, Ps2Mouse  (PS/2 ports)
//                +- UsbKeyboard, UsbMouse, UsbGamepad  (USB host ports of the HPS)
//                +- RemoteControl  (infrared receiver)
//                +- HeaderWires  (GPIO_0, GPIO_1)  --- Parts of the scenario
//                +- Accelerometer  (I2C0 of the HPS, or pins of the FPGA)
//                +- HpsLcd  (SPI master 0 of the HPS, of boards that have it)
//                +- SW  (BouncingContacts)
//                +- KEY, LEDR, HEX, HPS_KEY, HPS_LED
//
// The KEYs have Schmitt triggers that debounce them; the switches bounce.
//
// What is in the chip is not known here: sim/pins/chip.h.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "sim/board/accelerometer.h"
#include "sim/board/adv7180.h"
#include "sim/board/adv7513.h"
#include "sim/board/adxl345_wires.h"
#include "sim/board/board_observer.h"
#include "sim/board/bouncing_contacts.h"
#include "sim/board/header_wires.h"
#include "sim/board/hps_lcd.h"
#include "sim/board/is42s16320d.h"
#include "sim/board/keypad.h"
#include "sim/board/lamp.h"
#include "sim/board/ltc2308.h"
#include "sim/board/monitor.h"
#include "sim/board/parts.h"
#include "sim/board/ps2_keyboard.h"
#include "sim/board/ps2_mouse.h"
#include "sim/board/ps2_ports.h"
#include "sim/board/remote_control.h"
#include "sim/board/sound_source.h"
#include "sim/board/usb_ports.h"
#include "sim/board/wm8731.h"
#include "sim/pins/chip.h"

#include <systemc>

namespace sim {

// In what a board differs from the DE1-SoC.
struct BoardShape {
    std::set<std::string> on_i2c{"WM8731", "ADV7180"};  // the FPGA's: of these, and ADV7513
    bool has_blank = true;                              // BLANK_N, of the monitor
    bool hears_gsensor = false;  // INT1 of an accelerometer on pins of the FPGA is wired, too
    bool has_lcd = false;        // on pins of the HPS
    bool has_arduino = false;    // the Arduino header
};

class Board : public sc_core::sc_module, private PinListener {
    // Lamps by number: LEDs, segments, points, HPS_LED.
    static constexpr unsigned HEX_FIRST = LEDS, HPS_LED_NUMBER = HEX_FIRST + 8 * DIGITS;

public:
    // `seed` of the bounce of contacts: the keypad's and the switches'.
    Board(const sc_core::sc_module_name& name, BoardObserver& observer, std::uint64_t seed,
          Ps2Ports ps2_ports, const ChipMaker& make_chip,
          Monitor::Strictness vga = Monitor::Strictness::STRICT,
          const std::vector<PartPlan>& parts = {}, const UsbPlugs& usb_plugs = {},
          const BoardShape& shape = {});

    // Carries out what a person does now, once the chip has come to the present.
    void act(Agenda::Action action);

    // Hands on the board: masks of keypad keys (4 * row + column), HPS_KEY and KEY3-0, and
    // SWs, which bounce once or twice within a time; those that are moved at time 0 stand so
    // before power comes.
    void hold(std::uint16_t keypad, std::uint8_t keys, std::uint32_t switches,
              std::uint64_t bounce_ps = 0);
    void release(std::uint16_t keypad, std::uint8_t keys, std::uint32_t switches,
                 std::uint64_t bounce_ps = 0);

    // Drives pins of the headers by hand.
    void drive_pins(const HeaderMasks& pins, PinLevel level);

    // At that terminal; or at those where a program listens, the first JTAG UART's and a Linux
    // console, if there is one.
    void type(const std::string& text, std::optional<SerialLine> to) {
        chip_->type(text, to.value_or(SerialLine::JTAG_0));
        if (to.value_or(SerialLine::UART) == SerialLine::UART) typed_(text);
    }
    // The Linux console.
    void also_type_to(std::function<void(const std::string&)> terminal) {
        typed_ = std::move(terminal);
    }

    // As a person sees them now.
    const Lamps& lamps();
    // Tells the observer of those that are seen otherwise since they do not flash any more, as of
    // where the chip is.
    void settle_lamps();

    bool has_arduino() const { return has_arduino_; }  // the Arduino header

    Chip& chip() { return *chip_; }

private:
    void video(const std::uint32_t* samples, std::size_t count) override;
    void video_clock(std::uint64_t period_ps) override { monitor.clock_ps(period_ps); }
    void video_idle(std::uint64_t time_ps) override { monitor.idle(time_ps); }
    void codec(const CodecPins& pins, std::uint64_t time_ps, ChipInputs& in) override;
    void xck(std::uint64_t period_fs, std::uint64_t time_ps, ChipInputs& in) override;
    void bclk_edge(std::uint64_t time_ps, ChipInputs& in) override;
    void headers(const HeaderPins& pins, std::uint64_t time_ps, ChipInputs& in) override;
    void adc(const AdcPins& pins, std::uint64_t time_ps, ChipInputs& in) override;
    void gsensor(const GsensorPins& pins, std::uint64_t time_ps, ChipInputs& in) override;
    int analog_mv(unsigned input) const override { return adc_chip.millivolts(input); }
    void sdram(const SdramPins& pins, std::uint64_t time_ps, std::uint16_t& dq,
               bool& more) override;
    void lamps(const LampPins& pins, std::uint64_t time_ps) override;
    void ps2(unsigned clk_low, unsigned dat_low, std::uint64_t time_ps, ChipInputs& in) override;
    void hps_led(bool lit, std::uint64_t time_ps) override;
    void hps_gpio1(std::uint32_t levels) override { lcd.gpio1(levels); }
    void hps_spi0(std::uint32_t frame) override { lcd.spi0(frame); }
    I2cDevices* hps_i2c0() override { return &accelerometer; }
    std::uint8_t td_data(std::uint64_t rise) override { return video_decoder.data(rise); }
    void header_wires(ChipInputs& in, std::uint64_t time_ps);
    void headers_moved();
    void ps2_wires(ChipInputs& in) const;
    void light(unsigned first, std::uint64_t lit, std::uint64_t& was);
    void see(std::uint64_t time_ps);
    void hear(const StereoSample& sample, double rate_hz);

    BoardObserver& observer_;
    std::function<void(const std::string&)> typed_ = [](const std::string&) {};
    Lamps lamps_;
    struct {
        std::uint64_t leds = 0, hex = 0, hps_led = 0;
    } lit_;
    LampBank eyes_{HPS_LED_NUMBER + 1, [this](std::uint64_t time_ps) { see(time_ps); }};
    unsigned ps2_clk_low_ = 0, ps2_dat_low_ = 0;  // by the FPGA
    std::array<Ps2Device*, 2> ps2_{};             // in each port; may be none
    const bool has_codec_, has_decoder_, has_hdmi_, hears_gsensor_, has_arduino_;
    bool warned_ = false;  // that nothing may be seen
    double rate_hz_ = 0;   // of the samples given to the observer so far

public:  // the parts, in the order in which they are soldered
    Monitor monitor;
    SoundSource line_in, microphone;
    Wm8731 codec_chip;
    Adv7180 video_decoder;
    Ltc2308 adc_chip;
    Is42s16320d sdram_chip;
    Keypad keypad;
    BouncingContacts switches;
    Ps2Keyboard ps2_keyboard;
    Ps2Mouse ps2_mouse;
    UsbPorts usb;
    RemoteControl remote_control;
    Adv7513 hdmi_transmitter;
    Accelerometer accelerometer;
    Adxl345Wires accelerometer_wires{accelerometer.chip()};
    HpsLcd lcd;
    HeaderWires wires;
    Parts parts;

private:
    std::unique_ptr<Chip> chip_;  // the last: from here on pins move
};

}  // namespace sim
