// lamp_log.h - what is seen without a monitor, in the course of time: LEDR, HEX, HPS_LED, and
// the headers' pins.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "sim/board/board.h"
#include "sim/report/report.h"

namespace sim {

// What something showed over time: the first changes, and the number of all.
template <class State>
class Changes {
public:
    static constexpr std::size_t KEPT = 100;

    explicit Changes(State at_power_on) : now_{at_power_on} {}

    void show(double time_s, const State& state) {
        if (state == now_) return;
        now_ = state;
        if (first_.size() < KEPT)
            first_.emplace_back(time_s, state);
        else
            ++left_out_;
    }

    const State& now() const { return now_; }
    const std::vector<std::pair<double, State>>& first() const { return first_; }
    std::uint64_t left_out() const { return left_out_; }

private:
    State now_;
    std::vector<std::pair<double, State>> first_;
    std::uint64_t left_out_ = 0;
};

class LampLog {
public:
    // How the headers' pins are named: JP1 and JP2 with D31-D0, as the DE1-SoC Computer has them,
    // or GPIO_0 and GPIO_1 with all 36.  The Arduino header has one name.
    enum class Headers { JP, GPIO };

    void show(const Lamps& lamps, double time_s);
    // As the report has it.  The Arduino header is there if the board has one.
    std::vector<RunReport::Shown> shown(Headers headers, bool has_arduino) const;
    // What is not dark or at rest, as a person says it: "LEDR 1000000001, HEX \"    12\""; or "".
    std::string text(Headers headers) const;

private:
    Changes<std::uint32_t> ledr_{0};
    Changes<std::uint64_t> hex_{0};
    Changes<bool> hps_led_{false};
    std::vector<Changes<Lamps::Header>> headers_{HEADERS, Changes<Lamps::Header>{{}}};
};

}  // namespace sim
