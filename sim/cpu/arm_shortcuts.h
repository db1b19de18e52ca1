// arm_shortcuts.h - the rounds of a steady loop are not executed one by one
//
// The state after them is computed (steady_loop.h), and so is their time: that of the instructions,
// and of each access to the bus as it would have been.  So all is as without the shortcut; it can
// be seen neither from outside nor by the program.  It ends before SystemC's next event, before
// anything changes that the program reads, and one round before the loop ends; that round is
// executed and sets the flags.
//
// Costs a look at the code at pc per quantum; less often where no loop was found.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include <systemc>

#include "sim/cpu/answers.h"
#include "sim/cpu/arm_core.h"
#include "sim/cpu/arm_time.h"
#include "sim/cpu/steady_bus.h"
#include "sim/cpu/steady_loop.h"

namespace sim {

class ArmShortcuts {
public:
    ArmShortcuts(ArmCore& core, ArmTime& time) : core_{core}, time_{time} {}

    // Lets loops that use the bus be shortened, too.
    void set_bus(SteadyBus* bus) { bus_ = bus; }
    // Executes every round from now on.
    void disable() { enabled_ = false; }

    // Before a quantum of `most` instructions: leaves out what it can, which adds to the core's
    // instructions and to the time.  Returns how many to execute before the next call.
    // `stores_wait`: there are some in the store buffer.
    std::uint64_t pass(std::uint64_t most, bool stores_wait);
    // The register that a loop reads in which the program is, with its next instruction at `pc`.
    std::optional<std::uint32_t> polled(std::uint32_t pc);

    // ---- What it has to know ----

    // Time has passed in SystemC, or something else has changed that may be read.
    void changed() { ++events_; }
    // An access to the bus begins.
    void access_begins() { epoch_before_ = epoch(); }
    // It has been answered.  `waited`: while it waited, time passed in SystemC.
    void answered(std::uint32_t address, unsigned bytes, bool write, std::uint32_t value,
                  bool waited);

    // True: the next access has been made already, and the time is that of its end.
    bool replay();
    // What a read then gives.
    std::uint32_t replayed(std::uint32_t address, unsigned bytes) {
        return answers_.last(address, bytes, false, 0)->value;
    }

    // What accesses that were left out would have waited for their targets, in all.
    const sc_core::sc_time& on_bus() const { return on_bus_; }

private:
    class World;

    std::uint64_t epoch() const { return events_ + (bus_ ? bus_->changes() : 0); }
    bool pass_memory(std::uint64_t most);
    bool pass_bus();
    bool go_round(std::uint64_t& time, std::uint64_t end);
    void passed(std::uint64_t rounds);
    SteadyLoop::Registers registers(std::uint32_t pc) const;

    ArmCore& core_;
    ArmTime& time_;
    SteadyBus* bus_ = nullptr;
    bool enabled_ = true;
    SteadyLoop loop_;
    Answers answers_;
    std::uint64_t epoch_before_ = 0;      // the last access
    std::uint64_t events_ = 0;            // how often changed() was called
    std::vector<std::uint64_t> replays_;  // ends of the next accesses, the last first
    sc_core::sc_time on_bus_;
    unsigned looks_ = 0, pause_ = 0, longest_pause_ = 0;
    struct NoLoop {
        std::uint32_t pc = 1;
        unsigned times = 0;  // that none was found there
    };
    std::array<NoLoop, 64> no_loop_;
};

}  // namespace sim
