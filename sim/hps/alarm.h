// alarm.h - wakes a model at a time that is counted from the beginning of the simulation.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include <systemc>

namespace sim {

class Alarm : public sc_core::sc_module {
public:
    Alarm(const sc_core::sc_module_name& name, std::function<void()> ring)
        : sc_module{name}, ring_{std::move(ring)} {
        SC_HAS_PROCESS(Alarm);
        SC_METHOD(rung);
        sensitive << event_;
        dont_initialize();
    }

    // Replaces the time that was set before; without a value it never rings.  A time that has
    // passed rings at once.
    void set(std::optional<std::uint64_t> time_ps) {
        event_.cancel();
        if (!time_ps) return;
        const std::uint64_t now_ps = sc_core::sc_time_stamp().value();
        event_.notify(sc_core::sc_time::from_value(*time_ps > now_ps ? *time_ps - now_ps : 0));
    }

private:
    void rung() { ring_(); }

    std::function<void()> ring_;
    sc_core::sc_event event_;
};

}  // namespace sim
