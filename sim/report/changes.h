// changes.h - what something showed over time: the first changes, and the number of all
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace sim {

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

}  // namespace sim
