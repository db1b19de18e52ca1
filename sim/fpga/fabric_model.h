// fabric_model.h - the Verilated fabric as fabric.cpp and fabric_pins.cpp share it.
#pragma once

#include <algorithm>
#include <cstdint>

#include "sim/fpga/fabric.h"

#ifndef DE1SIM_PORTS_ALONE
#include "sim/verilated/evaluate.h"
#endif

#include "Vfpga.h"
#include "verilated.h"
#ifndef DE1SIM_PORTS_ALONE
#include "Vfpga___024root.h"
#endif
#if !defined DE1SIM_PORTS_ALONE && !defined DE1SIM_TRACE
// Which none of the model's headers has.
void Vfpga___024root___eval(Vfpga___024root *);
void Vfpga___024root___eval_ico(Vfpga___024root *);
void Vfpga___024root___eval_nba(Vfpga___024root *);
void Vfpga___024root___eval_triggers__act(Vfpga___024root *);
#endif
#ifdef DE1SIM_TRACE
#include "verilated_fst_c.h"
#endif
// Whether the model shows what fabric.vlt names.
#if !defined DE1SIM_PORTS_ALONE && !defined DE1SIM_TRACE
#define DE1SIM_KNOWS_CALM
#endif

namespace sim {

// Bits of `moved` in fpga_clocks.v.
enum Moved : std::uint8_t { LIGHTWEIGHT = 1, FULL = 2, PINS = 4 };

// The signals of one AXI3 port; both bridges have the same shapes.
struct Fabric::AxiPort {
    CData &awlen, &awsize, &awburst, &awvalid, &awready, &wstrb, &wvalid, &wready, &bresp, &bvalid,
        &bready, &arlen, &arsize, &arburst, &arvalid, &arready, &rresp, &rlast, &rvalid, &rready;
    SData &awid, &bid, &arid, &rid;
    IData &awaddr, &wdata, &araddr, &rdata;
};

#define AXI_PORT(m, b)                                                                           \
    {                                                                                            \
        m.b##_awlen_i, m.b##_awsize_i, m.b##_awburst_i, m.b##_awvalid_i, m.b##_awready_o,        \
            m.b##_wstrb_i, m.b##_wvalid_i, m.b##_wready_o, m.b##_bresp_o, m.b##_bvalid_o,        \
            m.b##_bready_i, m.b##_arlen_i, m.b##_arsize_i, m.b##_arburst_i, m.b##_arvalid_i,     \
            m.b##_arready_o, m.b##_rresp_o, m.b##_rlast_o, m.b##_rvalid_o, m.b##_rready_i,       \
            m.b##_awid_i, m.b##_bid_o, m.b##_arid_i, m.b##_rid_o, m.b##_awaddr_i, m.b##_wdata_i, \
            m.b##_araddr_i, m.b##_rdata_o                                                        \
    }

// Otherwise it starts a thread for each processor of the machine, which the model never uses.
inline VerilatedContext *of_one_thread(VerilatedContext &context) {
    context.threads(1);
    return &context;
}

struct Fabric::Model {
    VerilatedContext context;
    Vfpga top{of_one_thread(context)};
    AxiPort lw AXI_PORT(top, lw);
    AxiPort h2f AXI_PORT(top, h2f);
    // Or are those left out in which nothing happens?  (VGA_CLK rises in the middle of a clock.)
#if defined DE1SIM_TRACE
    bool every_clock = true;
    VerilatedFstC waveforms;
    Trace trace;
#elif defined DE1SIM_PORTS_ALONE
    static constexpr bool every_clock = true;
#else
    static constexpr bool every_clock = false;
#endif
    void eval([[maybe_unused]] std::uint64_t time_ps);
    void clock_every(bool every);
    // What a fabric whose groups sleep says and hears.  One in which all clocks run has no such
    // pins.
#ifdef DE1SIM_PORTS_ALONE
    bool td_awake() const { return true; }
    bool pins_may_move() const { return true; }
    std::uint64_t rest() const { return 0; }
    void leave_out(std::uint64_t) {}
    void notify_moved(std::uint8_t) {}
#else
    bool td_awake() const { return top.rootp->fpga__DOT__clocks__DOT__td_awake; }
    bool pins_may_move() const { return top.rootp->fpga__DOT__clocks__DOT__pins_may_move; }
    std::uint64_t rest() const { return top.rootp->fpga__DOT__clocks__DOT__rest; }
    void leave_out(std::uint64_t clocks) {
        top.rootp->fpga__DOT__clocks__DOT__skip = static_cast<SData>(clocks);
    }
    void notify_moved(std::uint8_t moved) { top.rootp->fpga__DOT__clocks__DOT__moved = moved; }
#endif
    // For Fabric::calm(): for how many clocks no block of registers wakes, if all sleep; whether
    // the characters are being cleared, which a register shows; whether the beam is in the line
    // before a frame's end; whether a pair of samples comes with the next edge of the audio clock.
    std::uint64_t ports_rest() const;
    bool cells_awake() const;
    bool last_line() const;
    bool pair_comes() const;
    AxiPort &port(bool full) { return full ? h2f : lw; }
};

// After the first evaluation, which is top.eval().
inline void Fabric::Model::eval([[maybe_unused]] std::uint64_t time_ps) {
#if !defined DE1SIM_PORTS_ALONE && !defined DE1SIM_TRACE
    // Without what is around it for waveforms and for several threads.
#if VERILATOR_VERSION_INTEGER == 5006000  // and its eval_act() is empty (a test: EmptyAct)
    verilated::evaluate<Vfpga___024root___eval_ico, Vfpga___024root___eval_triggers__act,
                        Vfpga___024root___eval_nba, Vfpga___024root___eval>(*top.rootp);
#else
    Vfpga___024root___eval(top.rootp);
#endif
#else
    top.eval();
#endif
#ifdef DE1SIM_TRACE
    if (waveforms.isOpen() && trace.wants(time_ps)) waveforms.dump(time_ps);
#endif
}

inline void Fabric::Model::clock_every([[maybe_unused]] bool every) {
#ifdef DE1SIM_TRACE
    every_clock = every;
    top.rootp->fpga__DOT__clocks__DOT__root__DOT__every_clock = every;
#endif
}

#ifdef DE1SIM_KNOWS_CALM
inline std::uint64_t Fabric::Model::ports_rest() const {
    return 1u + top.rootp->fpga__DOT__clocks__DOT__ports_rest;
}

inline bool Fabric::Model::cells_awake() const { return top.rootp->fpga__DOT__cells_awake; }

inline bool Fabric::Model::last_line() const {
    constexpr unsigned LAST_SHOWN = 479;
    return top.rootp->fpga__DOT__video_block__DOT__vga_block__DOT__timing__DOT__v_o == LAST_SHOWN;
}

inline bool Fabric::Model::pair_comes() const {
    return top.rootp->fpga__DOT__audio_block__DOT__serial_received;
}
#else
inline std::uint64_t Fabric::Model::ports_rest() const { return 0; }
inline bool Fabric::Model::cells_awake() const { return true; }
inline bool Fabric::Model::last_line() const { return true; }
inline bool Fabric::Model::pair_comes() const { return true; }
#endif

}  // namespace sim
