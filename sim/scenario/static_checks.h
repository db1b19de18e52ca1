// static_checks.h - mistakes that can be found before the run: controls that are held, files, the
// duration
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "sim/pins/pins.h"
#include "sim/scenario/scenario.h"

namespace sim {

// What a step may ask about the steps before it.  A mistake is thrown as a Refusal with its place.
class StaticChecks {
public:
    explicit StaticChecks(const Scenario& scenario) : scenario_{scenario}, usb_{scenario.usb} {}

    // A control by its name, "keypad 6": held by one step, and then free again by another.
    void need_free(const std::string& control) const;
    void hold(const std::string& control);
    void release(const std::string& control);

    // The board has this wire of the simulated chip, "SW[9]", or "HPS"; `what` for the message.
    void need_on_board(const std::string& wire, const std::string& what) const;
    void need_on_board(const HeaderMasks& pins) const;
    bool has_on_board(const std::string& wire) const { return scenario_.board.has(wire); }

    void need(Ps2Plug plug) const;
    // A device on USB, which only a Linux program has.
    void need(UsbPlug plug) const;
    // The gamepad that is meant: that of this number, or the only one.
    UsbPlugged need_gamepad(std::optional<unsigned> number) const;
    void plug(UsbPlug plug, std::optional<unsigned> number, bool in);
    bool is_held(const std::string& control) const { return held_since_.count(control) > 0; }
    // Of a kind as a scenario names it.
    const PartPlan& need_part(const std::string& kind, const std::string& name) const;
    // The monitor, or a part that shows a picture.
    void need_display(const std::string& name) const;

    // A file in the output folder that no other step and no run writes.
    void new_file(const std::filesystem::path& file);

    void need_linux() const;
    [[noreturn]] void refuse_step(const std::string& expected, const std::string& got) const;

private:
    friend void check_steps(const Scenario& scenario);
    friend class StepReader;

    const Scenario& scenario_;
    const ScenarioStep* step_ = nullptr;
    std::map<std::string, int> held_since_;  // line
    UsbPlugs usb_;
    std::map<std::filesystem::path, int> written_;  // line
};

// Throws Refusal if a step does, and for steps for which the duration leaves no time.
void check_steps(const Scenario& scenario);

}  // namespace sim
