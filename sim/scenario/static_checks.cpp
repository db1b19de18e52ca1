// static_checks.cpp - follows hands and clock through the steps
#include "sim/scenario/static_checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <regex>
#include <string>

#include "sim/report/run_files.h"
#include "sim/scenario/words.h"
#include "sim/scenario/yaml_tree.h"

namespace sim {

namespace {

[[noreturn]] void refuse_step(const Step& step, const std::string& expected,
                              const std::string& got) {
    throw Refusal{step.line, step.column, "expected " + expected + ", got " + got};
}

class Hands {
public:
    void check(const Step& step) {
        if (const auto* press = std::get_if<Press>(&step.action)) need_free(step, press->controls);
        if (const auto* hold = std::get_if<Hold>(&step.action)) {
            need_free(step, hold->controls);
            for (const unsigned n : control_numbers(hold->controls)) held_since_[n] = step.line;
        }
        if (const auto* release = std::get_if<Release>(&step.action)) {
            for (const unsigned n : control_numbers(release->controls)) {
                if (!held_since_[n])
                    refuse_step(step, "a control that is held", control_name(n) + ", which is not");
                held_since_[n] = 0;
            }
        }
    }

private:
    void need_free(const Step& step, const Controls& controls) const {
        for (const unsigned n : control_numbers(controls))
            if (held_since_[n])
                refuse_step(step, "a control that is free",
                            fmt::format("{}, held since line {} (overlapping times)",
                                        control_name(n), held_since_[n]));
    }

    std::array<int, CONTROLS> held_since_{};  // line; 0 = free
};

// The files that the screenshots become, in the output folder.
class Screenshots {
public:
    void check(const Step& step) {
        const auto* shot = std::get_if<TakeScreenshot>(&step.action);
        if (!shot) return;
        static const std::regex taken{RUN_NAMES};
        const std::filesystem::path file = shot->save_to.lexically_normal();
        const std::string name = in_quotes(shot->save_to.string());
        if (std::regex_match(file.begin()->string(), taken))
            refuse_step(step, "a file that the run does not write itself", name);

        // Paths are in the order of their parts: what is below one follows it.
        const auto next = lines_.lower_bound(file);
        const auto refuse_beside = [&](const char* where, const auto& other) {
            refuse_step(step, "a new file name",
                        fmt::format("{} {} {} of line {}", name, where,
                                    in_quotes(other.first.string()), other.second));
        };
        if (next != lines_.end() && next->first == file)
            refuse_step(step, "a new file name",
                        fmt::format("{} again, first in line {}", name, next->second));
        if (next != lines_.end() && is_below(next->first, file)) refuse_beside("above", *next);
        if (next != lines_.begin() && is_below(file, std::prev(next)->first))
            refuse_beside("below", *std::prev(next));
        lines_.emplace_hint(next, file, step.line);
    }

private:
    static bool is_below(const std::filesystem::path& file, const std::filesystem::path& folder) {
        return std::mismatch(folder.begin(), folder.end(), file.begin(), file.end()).first ==
               folder.end();
    }

    std::map<std::filesystem::path, int> lines_;
};

// The time that a step takes whatever the board does.
std::uint64_t least_ps(const Action& action) {
    if (const auto* delay = std::get_if<Delay>(&action)) return delay->time.ps;
    if (const auto* press = std::get_if<Press>(&action)) return press->time.ps;
    if (const auto* tone = std::get_if<ExpectTone>(&action)) return tone->time.ps;
    if (const auto* silence = std::get_if<ExpectSilence>(&action)) return silence->time.ps;
    return 0;
}

void check_times(const Scenario& scenario) {
    if (!scenario.duration) return;
    std::uint64_t now_ps = 0;
    for (std::size_t i = 0; i < scenario.steps.size(); ++i) {
        now_ps += least_ps(scenario.steps[i].action);
        if (now_ps <= scenario.duration->ps) continue;
        const bool is_last = i + 1 == scenario.steps.size();
        const Step& lost = scenario.steps[is_last ? i : i + 1];
        refuse_step(lost, "steps that fit into the duration of " + to_string(*scenario.duration),
                    fmt::format("\"{}\", which can not {} before {}", lost.text,
                                is_last ? "end" : "begin", to_string(SimTime{now_ps})));
    }
}

}  // namespace

void check_steps(const Scenario& scenario) {
    Hands hands;
    Screenshots screenshots;
    for (const Step& step : scenario.steps) {
        hands.check(step);
        screenshots.check(step);
    }
    check_times(scenario);
}

}  // namespace sim
