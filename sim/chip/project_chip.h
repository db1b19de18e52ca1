// project_chip.h - the chip as somebody's project fills it: a library that sim/project/ has built.
//
// As with Fpga it runs in batches: whenever somebody looks at a pin or moves one, whenever a
// processor accesses it, and once every 32 us.  The board's agenda is kept within them; with a
// processor its entries are events of SystemC, too, past which the processor does not run ahead.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "sim/pins/chip.h"
#include "sim/pins/trace.h"
#include "sim/project/model.h"

#include <systemc>

namespace sim {

class ProjectChip : public sc_core::sc_module, public Chip {
public:
    // `folder` is the project's.  `terminals` and `memory` may be null.  std::runtime_error: the
    // library cannot be loaded.
    ProjectChip(const sc_core::sc_module_name& name, PinListener& pins,
                const std::filesystem::path& library, const std::string& folder, const Trace& trace,
                project::JtagTerminals* terminals = nullptr,
                project::ProcessorMemory* memory = nullptr);
    ~ProjectChip() override;

    ChipInputs& inputs() override { return model_->in; }
    void catch_up() override;
    std::uint64_t time_ps() const override { return time_ps_; }
    void end_trace() override { model_->end_trace(); }
    std::optional<End> end() const override;

    // ---- For a processor ----

    project::Model& model() { return *model_; }
    // Runs up to this time, at most SystemC's next event, and notifies of what has changed.
    void run_to(std::uint64_t time_ps);
    // Model::run_to_answer().
    bool run_to_answer(std::uint64_t until_ps);
    // It is called by the design that runs.
    bool is_running() const { return is_running_; }
    struct Wires {
        std::function<void(std::uint64_t levels)> interrupts;   // Model::interrupts()
        std::function<void(unsigned requests)> reset_requests;  // Model::reset_requests()
    };
    // Each is called whenever its value has changed.
    void on_processor_wires(Wires wires);
    void notify_processor();
    // h2f_reset, of the length that a warm reset of the processor has.
    void reset(bool cold);

private:
    void end_reset();
    void look();
    void wait_for_board(std::uint64_t next_ps);

    struct Unload {
        void operator()(void* library) const;
    };
    std::unique_ptr<void, Unload> library_;
    std::unique_ptr<project::Model> model_;
    std::uint64_t time_ps_ = 0;
    bool is_running_ = false;
    sc_core::sc_event look_, board_moves_, reset_ends_;
    PinListener& pins_;
    Wires wires_;  // or none
    std::uint64_t interrupts_ = 0;
    unsigned reset_requests_ = 0;
};

}  // namespace sim
