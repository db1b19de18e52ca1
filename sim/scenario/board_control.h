// board_control.h - what a person in front of the board can do, see and hear, and wait for
//
// Steps act on this interface.  ScenarioRunner implements it for the simulated board; the tests of
// steps, which need no simulation, implement it for a mock board.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sim/board/header_part.h"
#include "sim/board/ps2_ports.h"
#include "sim/board/sound_source.h"
#include "sim/files/png.h"
#include "sim/pins/pins.h"
#include "sim/pins/serial_line.h"
#include "sim/scenario/controls.h"
#include "sim/scenario/observations.h"
#include "sim/scenario/seven_segment.h"
#include "sim/scenario/sim_time.h"

namespace sim {

class BoardControl {
public:
    // ---- Time ----

    virtual void wait(SimTime time) = 0;

    enum class Each { FRAME, CHARACTER, MILLISECOND };  // that was shown, printed, passed
    // Waits until `met`, which it calls now, after each of these, and at the end; false: not in
    // time.
    virtual bool wait_until(Each each, SimTime timeout, const std::function<bool()>& met) = 0;

    // ---- Files ----

    // With --update-goldens writes the golden picture again and returns true.
    virtual bool renew(const std::filesystem::path& golden, const Image& picture) = 0;

    // ---- Hands ----

    // Switches bounce within this time.
    virtual void hold(const Controls& controls, SimTime bounce) = 0;
    virtual void release(const Controls& controls, SimTime bounce) = 0;
    virtual void drive_pins(const HeaderMasks& pins, PinLevel level) = 0;
    virtual void set_voltage(unsigned channel, double volts) = 0;  // at the AD converter
    virtual void accelerate(double x, double y, double z) = 0;     // in g, felt from now on
    // Goes on at once.  Without `to` at the terminals where a program listens: Board::type().
    virtual void type_serial(const std::string& text, std::optional<SerialLine> to) = 0;
    virtual void type_keys(const std::string& text) = 0;  // goes on at once
    virtual void hold_key(std::uint16_t code) = 0;        // of the keyboard, see scan_codes.h
    virtual void release_key(std::uint16_t code) = 0;
    virtual void press_remote(std::uint8_t button) = 0;  // see nec_frame.h; goes on at once
    virtual void move_mouse(int right, int up) = 0;
    virtual void turn_wheel(int notches) = 0;  // towards the hand
    virtual void hold_button(MouseButton button) = 0;
    virtual void release_button(MouseButton button) = 0;

    // Into an input of the codec, from now on.
    virtual void play(SoundInput input, std::shared_ptr<const Recording> recording,
                      bool for_ever) = 0;
    virtual void play_tone(SoundInput input, double hz, double level) = 0;
    virtual void play_silence(SoundInput input) = 0;

    virtual void show_picture(std::shared_ptr<const Image> picture) = 0;  // to the camera

    // ---- Eyes and ears: what there is now ----

    virtual Observations& observations() = 0;
    // What a terminal among the parts has received.
    virtual ConsoleText& terminal(const std::string& part) = 0;
    virtual std::uint16_t ledr() = 0;
    virtual HexSegments hex() = 0;
    virtual bool hps_led() = 0;
    virtual HeaderMasks header_levels() = 0;

    // ---- The parts on the headers ----

    // By its name; StaticChecks::need_part() has found it.  To act on it, within act(); to observe
    // it, after now_ps().
    template <class Kind>
    Kind& part(const std::string& name) {
        return dynamic_cast<Kind&>(header_part(name));
    }
    // Carries out `action` now, once the chip has come to the present.
    virtual void act(std::function<void()> action) = 0;
    // The same with a control, by any name, that a finger presses: 50 ms later if it has just let
    // go of it.
    virtual void press(const std::string& control, std::function<void()> action) = 0;
    virtual void let_go(const std::string& control, std::function<void()> action) = 0;
    // Lets the chip come to the present.
    virtual std::uint64_t now_ps() = 0;

    // ---- The output folder ----

    virtual const std::filesystem::path& folder() const = 0;
    // False: it could not be written, which the report has as a fault.
    virtual bool save(const std::filesystem::path& path, const Image& image) = 0;

protected:
    ~BoardControl() = default;

private:
    virtual HeaderPart& header_part(const std::string& name) = 0;
};

}  // namespace sim
