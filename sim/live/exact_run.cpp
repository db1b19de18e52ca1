#include "sim/live/exact_run.h"

#include <algorithm>
#include <stdexcept>

#include <nlohmann/json.hpp>

#include "sim/scenario/sim_time.h"

namespace sim::live {

namespace {

constexpr std::uint64_t MS_PS = 1'000'000'000, LONGEST_PS = 10'000 * MS_PS;

bool has_happened(const std::string& what, const ExactRun::Counts& before,
                  const ExactRun::Counts& now) {
    if (what == "frame") return now.frames > before.frames;
    if (what == "picture") return now.pictures > before.pictures;
    if (what == "printed") return now.printed > before.printed;
    if (what == "lamps") return now.lamps > before.lamps;
    if (what == "pins") return now.pins > before.pins;
    return now.steps_are_done;
}

std::uint64_t length_ps(const nlohmann::json& length) {
    const auto time = length.is_string() ? SimTime::parse(length.get<std::string>()) : std::nullopt;
    if (!time || time->ps % MS_PS != 0 || time->ps > LONGEST_PS)
        throw std::runtime_error{
            "run: expected a time of whole milliseconds up to 10s, such as \"20ms\", got " +
            length.dump().substr(0, 100)};
    return time->ps;
}

}  // namespace

ExactRun::ExactRun(const nlohmann::json& order, const Counts& counts, sc_core::sc_time now)
    : before_{counts} {
    const bool conditions =
        order.is_object() && order.size() == 2 && order.contains("for") && order.contains("until");
    end_ = now + sc_core::sc_time::from_value(length_ps(conditions ? order["for"] : order));
    if (!conditions) return;
    static const std::vector<std::string> KNOWN{"frame", "picture", "printed",
                                                "lamps", "pins",    "steps"};
    for (const auto& what : order["until"]) {
        if (!what.is_string() || std::find(KNOWN.begin(), KNOWN.end(), what) == KNOWN.end())
            throw std::runtime_error{
                "run: expected a list of frame, picture, printed, lamps, pins and steps, got " +
                order["until"].dump().substr(0, 100)};
        until_.push_back(what);
    }
}

bool ExactRun::over(const Counts& counts, sc_core::sc_time now) const {
    return now >= end_ || !met(counts).empty();
}

std::vector<std::string> ExactRun::met(const Counts& counts) const {
    std::vector<std::string> all;
    for (const std::string& what : until_)
        if (has_happened(what, before_, counts)) all.push_back(what);
    return all;
}

}  // namespace sim::live
