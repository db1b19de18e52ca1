// sim_time.cpp - decimal text to picoseconds and back, without rounding
#include "sim/scenario/sim_time.h"

#include <fmt/format.h>

#include <algorithm>

namespace sim {

namespace {

struct Unit {
    std::string_view name;
    std::uint64_t ps;
};

constexpr Unit UNITS[] = {
    {"s", 1'000'000'000'000}, {"ms", 1'000'000'000}, {"us", 1'000'000}, {"ns", 1'000}};

bool is_digit(char c) { return c >= '0' && c <= '9'; }

std::string_view read_digits(std::string_view& text) {
    const auto end = std::find_if_not(text.begin(), text.end(), is_digit);
    const std::string_view digits = text.substr(0, static_cast<std::size_t>(end - text.begin()));
    text.remove_prefix(digits.size());
    return digits;
}

}  // namespace

std::optional<SimTime> SimTime::parse(std::string_view text) {
    const std::string_view whole = read_digits(text);
    std::string_view fraction;
    if (whole.empty()) return std::nullopt;
    if (!text.empty() && text.front() == '.') {
        text.remove_prefix(1);
        fraction = read_digits(text);
        if (fraction.empty()) return std::nullopt;
    }
    for (const Unit& unit : UNITS) {
        if (text != unit.name) continue;
        std::uint64_t ps = 0;
        for (const char digit : whole) {
            ps = ps * 10 + static_cast<unsigned>(digit - '0') * unit.ps;
            if (ps > MAX_SIM_TIME.ps) return std::nullopt;
        }
        std::uint64_t place = unit.ps;
        for (const char digit : fraction) {
            if (digit != '0' && place % 10 != 0) return std::nullopt;
            place /= 10;
            ps += static_cast<unsigned>(digit - '0') * place;
        }
        if (ps > MAX_SIM_TIME.ps) return std::nullopt;
        return SimTime{ps};
    }
    return std::nullopt;
}

std::string to_string(SimTime time) {
    if (time.ps == 0) return "0s";
    const Unit* unit = std::begin(UNITS);
    while (unit != std::end(UNITS) - 1 && time.ps < unit->ps) ++unit;
    std::string text = std::to_string(time.ps / unit->ps);
    if (std::uint64_t rest = time.ps % unit->ps) {
        const std::string digits = std::to_string(unit->ps + rest).substr(1);
        text += "." + digits.substr(0, digits.find_last_not_of('0') + 1);
    }
    return text + std::string(unit->name);
}

std::string within(SimTime timeout) {
    return timeout.ps == 0 ? "" : " within " + to_string(timeout);
}

}  // namespace sim
