// project_computer.h - the chip as somebody's project fills it, with the processor: a Platform
// Designer system
//
//   ProcessorSystem --+- FpgaBridges --> FpgaChip with ProjectDesign --> pins
//                     +- ProjectMasters <------+
#pragma once

#include <deque>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "sim/chip/fpga_bridges.h"
#include "sim/chip/fpga_chip.h"
#include "sim/chip/processor_system.h"
#include "sim/chip/project_chip.h"
#include "sim/chip/project_code.h"
#include "sim/chip/project_masters.h"
#include "sim/chip/project_peripherals.h"
#include "sim/project/qsys/generate.h"

namespace sim {

class ProjectComputer : public ProcessorSystem, public Chip, project::JtagTerminals {
public:
    // `library` and `folder` as ProjectDesign has them, `ddr3_mb_per_s` as ProjectMasters.
    ProjectComputer(const sc_core::sc_module_name& name, PinListener& pins, ChipObserver& observer,
                    Software software, const std::filesystem::path& library,
                    const std::string& folder, const Trace& trace,
                    const project::qsys::Generated& system, unsigned ddr3_mb_per_s);

    ChipInputs& inputs() override { return design.model().in; }
    void catch_up() override { fpga.catch_up(); }
    std::uint64_t time_ps() const override {
        return arm && arm->is_running() ? arm->now().value() : fpga.time_ps();
    }
    void hps_key(bool pressed) override { hps.gpio1.press_key(pressed); }
    void hps_accelerometer_interrupt(bool up) override { accelerometer_interrupt(up); }
    void type(const std::string& text, SerialLine to) override;
    std::optional<End> end() const override;
    std::optional<PixelBuffer> pixel_buffer() const override { return system_.pixels; }
    void end_trace() override { design.model().end_trace(); }

    void close_bridges() override { bridges.close(); }
    bool is_accessing() const override { return bridges.is_busy(); }

    ProjectMasters masters;
    ProjectDesign design;
    FpgaChip fpga;
    FpgaBridges bridges;
    ProjectPeripherals peripherals;

private:
    void reset_fpga(bool cold) override { fpga.reset(cold); }
    void general_purpose(std::uint32_t gpo, const sc_core::sc_time& now) override;
    std::uint32_t general_purpose(const sc_core::sc_time& now) override;
    void request_reset(unsigned requests);
    void release_processor();
    void report_held_reset();
    void serve_code();
    void begin_program();
    void sent(unsigned number, char character) override;
    std::optional<char> typed(unsigned number) override;
    void report_stray(std::uint32_t address, bool write);
    std::vector<Bus::Place> places_of(std::uint32_t window, std::uint32_t size);

    const project::qsys::Generated system_;
    ChipObserver& observer_;
    std::deque<char> typed_[2];  // at the JTAG UARTs
    std::set<std::string> reported_;
    unsigned reset_requests_ = 0, resets_ = 0;
    std::unique_ptr<ProjectCode> code_;  // of an ARM's program
    bool has_begun_ = false;             // the program may run
    std::optional<std::string> unloaded_;
    sc_core::sc_event reset_held_;
    sc_core::sc_time last_reset_;
};

}  // namespace sim
