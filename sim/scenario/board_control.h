// board_control.h - what a person in front of the board can do, see and hear, and wait for
//
// Steps act on this interface.  ScenarioRunner implements it for the simulated board; the tests of
// steps, which need no simulation, implement it for a mock board.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "sim/board/header_part.h"
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
    // Goes on at once.  Without `to` at the terminals where a program listens: Board::type().
    virtual void type_serial(const std::string& text, std::optional<SerialLine> to) = 0;

    // ---- Eyes and ears: what there is now ----

    virtual Observations& observations() = 0;
    // What a terminal among the parts has received.
    virtual ConsoleText& terminal(const std::string& part) = 0;
    virtual std::uint32_t ledr() = 0;
    virtual HexSegments hex() = 0;
    virtual bool hps_led() = 0;
    virtual HeaderMasks header_levels() = 0;

    // ---- Parts ----

    // By its name, see sim/board/parts.h; StaticChecks::need_part() has found a scenario's.  Acted
    // on within act(); observed after catch_up().
    template <class Kind>
    Kind& part(const std::string& name) {
        return dynamic_cast<Kind&>(any_part(name));
    }
    // Carries out `action` now.
    virtual void act(std::function<void()> action) = 0;
    // The same with a control, by any name, that a finger presses: 50 ms later if it has just let
    // go of it.
    virtual void press(const std::string& control, std::function<void()> action) = 0;
    virtual void let_go(const std::string& control, std::function<void()> action) = 0;
    // Lets the chip come to the present.
    virtual void catch_up() = 0;
    virtual std::uint64_t now_ps() const = 0;

    // ---- The output folder ----

    virtual const std::filesystem::path& folder() const = 0;
    // False: it could not be written, which the report has as a fault.
    virtual bool save(const std::filesystem::path& path, const Image& image) = 0;

protected:
    ~BoardControl() = default;

private:
    virtual Part& any_part(const std::string& name) = 0;
};

}  // namespace sim
