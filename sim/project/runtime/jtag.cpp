#include "sim/project/runtime/jtag.h"

#include <vector>

#include "sim/project/runtime/endings.h"

namespace sim::project {

namespace {

constexpr std::uint64_t FRAME_PS = 1'000'000'000;

JtagTerminals* terminals = nullptr;
std::vector<std::uint64_t> next_look_ps;  // by number

}  // namespace

void set_jtag_terminals(JtagTerminals* of_design) {
    terminals = of_design;
    next_look_ps.clear();
}

}  // namespace sim::project

extern "C" int de1sim_jtag_open() {
    using namespace sim::project;
    next_look_ps.push_back(FRAME_PS);
    return static_cast<int>(next_look_ps.size() - 1);
}

extern "C" int de1sim_jtag_look(int number, int room) {
    using namespace sim::project;
    constexpr int LOOKED = 1, SENDS = 2, PAUSES = 4;
    const auto n = static_cast<unsigned>(number);
    if (evaluated.time_ps < next_look_ps[n]) return 0;
    next_look_ps[n] = evaluated.time_ps / FRAME_PS * FRAME_PS + FRAME_PS;
    if (!room) return LOOKED;
    const std::optional<char> typed = terminals ? terminals->typed(n) : std::nullopt;
    if (!typed) return LOOKED | PAUSES;
    return LOOKED | SENDS | static_cast<unsigned char>(*typed) << 8;
}

extern "C" void de1sim_jtag_sent(int number, int data) {
    using namespace sim::project;
    if (terminals) terminals->sent(static_cast<unsigned>(number), static_cast<char>(data));
}
