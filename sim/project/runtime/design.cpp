// design.cpp - is compiled with each design: the Verilated de1sim_chip, as chip.h has it.
#include <cstdint>
#include <memory>
#include <string>

#include "Vde1sim_chip.h"
#include "verilated.h"
#ifdef DE1SIM_TRACE
#include "verilated_fst_c.h"
#endif

#include "chip.h"

#include "de1sim_facts.h"  // PLL_CLOCKS and so on
#include "de1sim_loops.h"  // LOOPS

namespace sim::project {

namespace {

// Otherwise it starts a thread for each processor of the machine, which the design never uses.
VerilatedContext* of_one_thread(VerilatedContext& context) {
    context.threads(1);
    return &context;
}

class VerilatedChip final : public Chip {
public:
    ChipPorts ports() override {
#define DE1SIM_PORT(type, name) top_.name,
        return {DE1SIM_CHIP_PORTS(DE1SIM_PORT)};
#undef DE1SIM_PORT
    }
    void eval(std::uint64_t now_ps) override {
        context_.time(now_ps);
        top_.eval();
    }
    void final() override { top_.final(); }

#ifdef DE1SIM_TRACE
    bool begin_trace(const std::string& file) override {
        context_.traceEverOn(true);
        top_.trace(&waveforms_, 99);
        waveforms_.open(file.c_str());
        return waveforms_.isOpen();
    }
    void dump(std::uint64_t time_ps) override { waveforms_.dump(time_ps); }
    void end_trace() override { waveforms_.close(); }
#else
    bool begin_trace(const std::string&) override { return false; }
    void dump(std::uint64_t) override {}
    void end_trace() override {}
#endif

private:
    VerilatedContext context_;
    Vde1sim_chip top_{of_one_thread(context_)};
#ifdef DE1SIM_TRACE
    VerilatedFstC waveforms_;
#endif
};

constexpr DesignFacts FACTS{PLL_CLOCKS,     PLL_CLOCK_COUNT,     TD_CLK27_USED,
                            VGA_USED,       AUD_XCK_USED,        AUD_CLOCKS_DRIVEN,
                            SOURCE_FOLDERS, SOURCE_FOLDER_COUNT, LOOPS};

}  // namespace

}  // namespace sim::project

extern "C" __attribute__((visibility("default"))) sim::project::Model* de1sim_open_model(
    sim::PinListener& pins, const sim::project::ModelSettings& settings) {
    using namespace sim::project;
    return play(std::make_unique<VerilatedChip>(), FACTS, pins, settings);
}
