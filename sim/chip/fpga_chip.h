// fpga_chip.h - what is in the FPGA, in SystemC's time: whatever it is
//
// It runs in batches: whenever somebody looks at a pin or moves one, whenever a processor accesses
// it, and once every 32 us, a scan line; then the listener is notified of the picture, so that a
// frame's end does not depend on accesses.  The board's agenda is kept within them; with a
// processor its entries are events of SystemC, too, past which the processor does not run ahead.
//
// Interrupts are levels, notified when the FPGA has come past their change: at once when an access
// makes it, else within 32 us.
#pragma once

#include <cstdint>
#include <functional>

#include "sim/pins/fpga_model.h"

#include <systemc>

namespace sim {

// SystemC's resolution is 1 ps.
inline sc_core::sc_time picoseconds(std::uint64_t ps) { return sc_core::sc_time::from_value(ps); }

// How the processor's clock and that of its bridges meet.  They come from two oscillators on the
// board, here from one.  What the bridges' clock quantises, an answer and the batch of 32 us, so
// reaches the processor up to half a clock earlier or later, by a hash of the number of such
// meetings and of the seed: evenly spread over the clock, and the same in every run.
class ClockPhases {
public:
    ClockPhases() = default;  // neither earlier nor later
    ClockPhases(std::uint64_t clock_ps, std::uint64_t seed) : clock_ps_{clock_ps}, seed_{seed} {}

    std::uint64_t clock_ps() const { return clock_ps_; }  // 0: there are none
    // Of a meeting at this time: when it is seen, not before `earliest_ps`.
    std::uint64_t seen(std::uint64_t time_ps, std::uint64_t earliest_ps);

private:
    std::uint64_t clock_ps_ = 0, seed_ = 0, meetings_ = 0;
};

class FpgaChip : public sc_core::sc_module {
public:
    // `model` lives longer.
    FpgaChip(const sc_core::sc_module_name& name, PinListener& pins, FpgaModel& model,
             ClockPhases phases = {});
    ~FpgaChip() override;

    FpgaModel& model() { return model_; }
    const FpgaModel& model() const { return model_; }
    // Everything up to now has been run and handed to the listener.
    void catch_up();
    // Up to which it has been run.
    std::uint64_t time_ps() const { return time_ps_; }

    // ---- For a processor ----

    // Runs up to this time, at most SystemC's next event, and notifies of what has changed.
    void run_to(std::uint64_t time_ps);
    // How often that was done.
    std::uint64_t batches() const { return batches_; }
    // FpgaModel::run_to_answer(), run_to_posted().
    bool run_to_answer(std::uint64_t until_ps);
    bool run_to_posted(std::uint64_t until_ps, unsigned most);
    // It is called by the model that runs.
    bool is_running() const { return is_running_; }
    // Each is called whenever its value has changed.
    struct Wires {
        std::function<void(std::uint64_t levels)> interrupts;   // FpgaModel::interrupts()
        std::function<void(unsigned requests)> reset_requests;  // FpgaModel::reset_requests()
    };
    void on_processor_wires(Wires wires);
    void notify_processor();
    // h2f_reset, of the length that a warm reset of the processor has.
    void reset(bool cold);
    ClockPhases& phases() { return phases_; }
    const ClockPhases& phases() const { return phases_; }

private:
    void end_reset();
    void look();
    void board_moves();
    void wait_for_board(std::uint64_t next_ps);

    PinListener& pins_;
    FpgaModel& model_;
    ClockPhases phases_;
    std::uint64_t time_ps_ = 0, batches_ = 0;
    bool is_running_ = false;
    sc_core::sc_event look_, board_moves_, reset_ends_;
    Wires wires_;  // or none
    std::uint64_t interrupts_ = 0;
    unsigned reset_requests_ = 0;
};

}  // namespace sim
