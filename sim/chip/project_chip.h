// project_chip.h - somebody's project in the chip: a library that sim/project/ has built.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "sim/chip/fpga_chip.h"
#include "sim/pins/chip.h"
#include "sim/pins/trace.h"
#include "sim/project/model.h"

#include <systemc>

namespace sim {

class ProjectDesign {
public:
    // `folder` is the project's.  `terminals` and `memory` may be null.  std::runtime_error: the
    // library cannot be loaded.
    ProjectDesign(PinListener& pins, const std::filesystem::path& library,
                  const std::string& folder, const Trace& trace,
                  project::JtagTerminals* terminals = nullptr,
                  project::ProcessorMemory* memory = nullptr);

    FpgaModel& model() { return *model_; }
    const FpgaModel& model() const { return *model_; }
    std::optional<Chip::End> end() const;

private:
    struct Unload {
        void operator()(void* library) const;
    };
    std::unique_ptr<void, Unload> library_;
    std::unique_ptr<FpgaModel> model_;
};

// A project without a processor.
class ProjectChip : public Chip {
public:
    ProjectChip(PinListener& pins, const std::filesystem::path& library, const std::string& folder,
                const Trace& trace)
        : design_{pins, library, folder, trace}, fpga_{"chip", pins, design_.model()} {}

    ChipInputs& inputs() override { return design_.model().in; }
    void catch_up() override { fpga_.catch_up(); }
    std::uint64_t time_ps() const override { return fpga_.time_ps(); }
    void end_trace() override { design_.model().end_trace(); }
    std::optional<End> end() const override { return design_.end(); }

private:
    ProjectDesign design_;
    FpgaChip fpga_;
};

}  // namespace sim
