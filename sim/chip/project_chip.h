// project_chip.h - the chip as somebody's project fills it: a library that sim/project/ has built.
//
// It has no processor.  As with Fpga it runs in batches: whenever somebody looks at a pin or moves
// one, and once every 32 us.  The board's agenda is kept within them.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "sim/chip/chip.h"
#include "sim/pins/trace.h"
#include "sim/project/model.h"

#include <systemc>

namespace sim {

class ProjectChip : public sc_core::sc_module, public Chip {
public:
    // `folder` is the project's.  std::runtime_error: the library cannot be loaded.
    ProjectChip(const sc_core::sc_module_name& name, PinListener& pins,
                const std::filesystem::path& library, const std::string& folder,
                const Trace& trace);
    ~ProjectChip() override;

    ChipInputs& inputs() override { return model_->in; }
    void catch_up() override;
    std::uint64_t time_ps() const override { return time_ps_; }
    void end_trace() override { model_->end_trace(); }
    std::optional<End> end() const override;

private:
    void look();

    struct Unload {
        void operator()(void* library) const;
    };
    std::unique_ptr<void, Unload> library_;
    std::unique_ptr<project::Model> model_;
    std::uint64_t time_ps_ = 0;
    sc_core::sc_event look_;
};

}  // namespace sim
