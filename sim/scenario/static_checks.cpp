// static_checks.cpp - tracks held controls, files and the time through the steps
#include "sim/scenario/static_checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "sim/files/run_files.h"
#include "sim/pins/header_pin.h"
#include "sim/scenario/yaml_tree.h"
#include "sim/text/pattern.h"
#include "sim/text/words.h"

namespace sim {

namespace {

bool is_below(const std::filesystem::path& file, const std::filesystem::path& folder) {
    return std::mismatch(folder.begin(), folder.end(), file.begin(), file.end()).first ==
           folder.end();
}

}  // namespace

void StaticChecks::refuse_step(const std::string& expected, const std::string& got) const {
    throw Refusal{step_->line, step_->column, "expected " + expected + ", got " + got};
}

// ---- Hands ----

void StaticChecks::need_free(const std::string& control) const {
    const auto held = held_since_.find(control);
    if (held != held_since_.end())
        refuse_step(
            "a control that is free",
            fmt::format("{}, held since line {} (overlapping times)", control, held->second));
}

void StaticChecks::hold(const std::string& control) {
    need_free(control);
    held_since_[control] = step_->line;
}

void StaticChecks::release(const std::string& control) {
    if (!held_since_.erase(control))
        refuse_step("a control that is held", control + ", which is not");
}

void StaticChecks::need_on_board(const std::string& wire, const std::string& what) const {
    const BoardParts& board = scenario_.board;
    if (board.has(wire)) return;
    // Of a bus that it has, how much of it.
    const std::string bus = wire.substr(0, wire.find('['));
    const auto count = std::count_if(
        board.wires.begin(), board.wires.end(),
        [&](const std::string& own) { return own != bus && own.substr(0, own.find('[')) == bus; });
    const std::string numbers =
        count ? fmt::format(": it has 0 to {}", count - 1) : ", which it has not";
    refuse_step("a step for what the " + board.name + " has", "one for " + what + numbers);
}

void StaticChecks::need_on_board(const HeaderMasks& pins) const {
    for (HeaderPin pin = 0; pin < HEADERS * PINS_OF_A_HEADER; ++pin)
        if (is_high(pins, pin)) need_on_board(pin_name(pin), pin_name(pin) + " of the headers");
}

void StaticChecks::need(Ps2Plug plug) const {
    need_on_board(scenario_.ps2.first == plug ? "PS2_CLK" : "PS2_CLK2", "a PS/2 port");
    if (!scenario_.ps2.has(plug))
        refuse_step(plug == Ps2Plug::MOUSE ? "a mouse among ps2" : "a keyboard among ps2", "none");
}

namespace {

const char* name_of(UsbPlug plug) {
    constexpr const char* NAMES[] = {"a keyboard", "a mouse", "a gamepad", "a snes-gamepad"};
    return NAMES[static_cast<std::size_t>(plug)];
}

std::string numbers_of(const std::vector<UsbPlugged>& gamepads) {
    std::vector<std::string> numbers;
    for (const UsbPlugged& one : gamepads) numbers.push_back(fmt::format("pad: {}", one.number));
    return list_of(numbers);
}

}  // namespace

void StaticChecks::need_linux() const {
    if (!scenario_.on_linux) refuse_step("a Linux program, which has the USB ports", "none");
}

void StaticChecks::need(UsbPlug plug) const {
    need_linux();
    if (!usb_.has(plug)) refuse_step(name_of(plug) + std::string{" in a USB port"}, "none");
}

UsbPlugged StaticChecks::need_gamepad(std::optional<unsigned> number) const {
    need_linux();
    const auto all = usb_.gamepads(), found = usb_.gamepads(number);
    if (all.empty()) refuse_step("a gamepad in a USB port", "none");
    if (found.empty())
        refuse_step("a gamepad that is in a USB port: " + numbers_of(all),
                    fmt::format("pad: {}", *number));
    if (found.size() > 1)
        refuse_step(numbers_of(all) + " in the step, as two gamepads are in USB ports", "neither");
    return found.front();
}

void StaticChecks::plug(UsbPlug plug, std::optional<unsigned> number, bool in) {
    need_linux();
    const std::string name = name_of(plug);
    if (number && !is_gamepad(plug))
        refuse_step(fmt::format("a gamepad with pad: {}", *number), name);
    if (in && is_gamepad(plug)) {
        const unsigned free = usb_.free_number();
        if (free == 0) refuse_step("a gamepad less in the USB ports", "two that are in them");
        if (!usb_.gamepads(number.value_or(free)).empty())
            refuse_step(fmt::format("pad: {}, which is free", free),
                        fmt::format("pad: {}", *number));
        return usb_.plug({plug, number.value_or(free)});
    }
    if (in && usb_.has(plug)) refuse_step(name + " that is in no USB port", "one that is in one");
    if (in) return usb_.plug({plug});
    need(plug);
    std::vector<UsbPlugged> found = usb_.of(plug, number);
    if (found.empty())
        refuse_step(name + " in a USB port: " + numbers_of(usb_.of(plug)),
                    fmt::format("pad: {}", *number));
    if (found.size() > 1)
        refuse_step(numbers_of(found) + " in the step, as two of them are in USB ports", "neither");
    usb_.unplug(found.front());
}

const PartPlan& StaticChecks::need_part(const std::string& kind, const std::string& name) const {
    std::vector<std::string> names;
    for (const PartPlan& part : scenario_.parts) {
        if (part.kind != kind) continue;
        if (part.name == name) return part;
        names.push_back(part.name);
    }
    // "LED" and "LT24" begin with an L that is spoken alone.
    const std::string a_kind = (kind[0] == 'l' ? "an " : "a ") + kind;
    refuse_step(names.empty() ? a_kind + " among the parts"
                              : fmt::format("{} of the parts: {}", a_kind, list_of(names)),
                in_quotes(name) + did_you_mean(name, names));
}

void StaticChecks::need_display(const std::string& name) const {
    std::vector<std::string> names{"monitor"};
    for (const PartPlan& part : scenario_.parts)
        if (part.is_display) names.push_back(part.name);
    if (scenario_.board.has("HPS LCD")) names.emplace_back("HPS LCD");
    if (std::find(names.begin() + 1, names.end(), name) != names.end()) return;
    refuse_step("a display: " + list_of(names), in_quotes(name) + did_you_mean(name, names));
}

// ---- Files ----

void StaticChecks::new_file(const std::filesystem::path& as_written) {
    static const Pattern taken{RUN_NAMES};
    const std::filesystem::path file = as_written.lexically_normal();
    const std::string name = in_quotes(as_written.string());
    if (taken.matches(file.begin()->string()))
        refuse_step("a file that the run does not write itself", name);

    // Paths are sorted by their components, so what is below a folder follows it.
    const auto next = written_.lower_bound(file);
    const auto refuse_beside = [&](const char* where, const auto& other) {
        refuse_step("a new file name", fmt::format("{} {} {} of line {}", name, where,
                                                   in_quotes(other.first.string()), other.second));
    };
    if (next != written_.end() && next->first == file)
        refuse_step("a new file name",
                    fmt::format("{} again, first in line {}", name, next->second));
    if (next != written_.end() && is_below(next->first, file)) refuse_beside("above", *next);
    if (next != written_.begin() && is_below(file, std::prev(next)->first))
        refuse_beside("below", *std::prev(next));
    written_.emplace_hint(next, file, step_->line);
}

// ---- The clock ----

namespace {

void check_pins(const BoardParts& board, const PartPlan& part) {
    for (const HeaderPinList* pins : {&part.pins, &part.shared})
        for (const HeaderPin pin : *pins)
            if (!board.has(pin_name(pin)))
                throw Refusal{part.line, part.column,
                              fmt::format("expected pins of the {}, got {}, which it has not",
                                          board.name, pin_name(pin))};
}

}  // namespace

void check_steps(const Scenario& scenario) {
    StaticChecks checks{scenario};
    for (const PartPlan& part : scenario.parts) check_pins(scenario.board, part);
    for (const ScenarioStep& step : scenario.steps) {
        checks.step_ = &step;
        step.step->check(checks);
    }
    if (!scenario.duration) return;
    std::uint64_t now_ps = 0;
    for (std::size_t i = 0; i < scenario.steps.size(); ++i) {
        now_ps += scenario.steps[i].step->least().ps;
        if (now_ps <= scenario.duration->ps) continue;
        const bool is_last = i + 1 == scenario.steps.size();
        checks.step_ = &scenario.steps[is_last ? i : i + 1];
        checks.refuse_step("steps that fit into the duration of " + to_string(*scenario.duration),
                           fmt::format("\"{}\", which can not {} before {}", checks.step_->text,
                                       is_last ? "end" : "begin", to_string(SimTime{now_ps})));
    }
}

}  // namespace sim
