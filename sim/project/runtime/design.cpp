// design.cpp - is compiled with each design: the Verilated de1sim_chip, as design.h has it.
#include <cstdint>
#include <memory>
#include <string>
#include <utility>

#include "Vde1sim_chip.h"
#include "Vde1sim_chip__Syms.h"
#include "Vde1sim_chip___024root.h"
#include "verilated.h"
#ifdef DE1SIM_TRACE
#include "verilated_fst_c.h"
#endif

#include "design.h"
#include "sim/verilated/evaluate.h"

#include "de1sim_facts.h"  // PLL_CLOCKS and so on
#include "de1sim_loops.h"  // LOOPS

// The parts of the model's evaluation, which none of its headers has.
using DesignRoot = Vde1sim_chip___024root;
void Vde1sim_chip___024root___eval_static(DesignRoot*);
void Vde1sim_chip___024root___eval_initial(DesignRoot*);
void Vde1sim_chip___024root___eval_settle(DesignRoot*);
void DE1SIM_EVAL_TRIGGERS(DesignRoot*);  // of which the name depends on Verilator's release
void Vde1sim_chip___024root___eval(DesignRoot*);
void Vde1sim_chip___024root___eval_ico(DesignRoot*);
void Vde1sim_chip___024root___eval_nba(DesignRoot*);

namespace sim::project {

namespace {

// Whether what has to be executed once, at the beginning, has been; not in each design.
template <class Root>
auto execute_once_again(Root& root, int) -> decltype(void(root.__VactDidInit)) {
    root.__VactDidInit = 0;
}
template <class Root>
void execute_once_again(Root&, long) {}

// What is 1 when the chip has powered up has not risen.  But the model would remember for
// `always @(posedge x)` what x was before the design has settled, and take a 1 for an edge.  So it
// looks for edges once more than it does by itself, and what it finds then is not executed.
void power_up(Vde1sim_chip& chip) {
    DesignRoot& root = *chip.rootp;
    root.vlSymsp->__Vm_didInit = true;
    Vde1sim_chip___024root___eval_static(&root);
    Vde1sim_chip___024root___eval_initial(&root);
    Vde1sim_chip___024root___eval_settle(&root);
    DE1SIM_EVAL_TRIGGERS(&root);
    execute_once_again(root, 0);
}

// Without what is around it for waveforms, for several threads and for objects of classes.
void evaluate(DesignRoot& root) {
#ifdef DE1SIM_NOTHING_IN_ACT
    verilated::evaluate<Vde1sim_chip___024root___eval_ico, DE1SIM_EVAL_TRIGGERS,
                        Vde1sim_chip___024root___eval_nba, Vde1sim_chip___024root___eval>(root);
#else
    Vde1sim_chip___024root___eval(&root);
#endif
}

// Otherwise it starts a thread for each processor of the machine, which the design never uses.
VerilatedContext* of_one_thread(VerilatedContext& context) {
    context.threads(1);
    return &context;
}

class VerilatedDesign final : public Design {
public:
    ChipPorts ports() override {
        return {
#define CHIP_PORT(name, kind, bits) top_.name,
#include "sim/pins/chip_wires.def"
        };
    }
    std::uint64_t eval(std::uint64_t now_ps, PinLevels& levels) override {
        const DesignRoot& chip = *top_.rootp;
        context_.time(now_ps);
        note_levels(levels, chip);
        if (!std::exchange(is_up_, true)) power_up(top_);
#ifdef DE1SIM_TRACE
        top_.eval();
#else
        evaluate(*top_.rootp);
#endif
        levels.clocks = chip.clocks_o;
        return moved(levels, chip);
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
    bool is_up_ = false;
#ifdef DE1SIM_TRACE
    VerilatedFstC waveforms_;
#endif
};

#ifdef DE1SIM_TRACE
constexpr bool PULSES = false;
#else
constexpr bool PULSES = true;
#endif
constexpr DesignFacts FACTS{PLL_CLOCKS,     PLL_CLOCK_COUNT,
                            PULSES,         CLOCK_50_ONLY_RISES,
                            CLOCK_50_SEEN,  CLOCK_50_PINS,
                            TD_CLK27_USED,  VGA_USED,
                            AUD_XCK_USED,   AUD_CLOCKS_DRIVEN,
                            SOURCE_FOLDERS, SOURCE_FOLDER_COUNT,
                            PLACED_UARTS,   LOOPS};

}  // namespace

}  // namespace sim::project

extern "C" __attribute__((visibility("default"))) sim::FpgaModel* de1sim_open_model(
    sim::PinListener& pins, const sim::project::ModelSettings& settings) {
    using namespace sim::project;
    return play(std::make_unique<VerilatedDesign>(), FACTS, pins, settings);
}
