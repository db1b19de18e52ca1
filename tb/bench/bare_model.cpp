#include "tb/bench/bare_model.h"

#include <algorithm>
#include <chrono>

#include "sim/verilated/triggers.h"  // before the model's own headers

#include "Vfpga.h"
#include "Vfpga___024root.h"
#include "sim/fpga/asynchronous_clock.h"
#include "verilated.h"

namespace bench {

namespace {

constexpr unsigned ALL = 7;  // of `moved` in sim/fpga/fpga_clocks.v

class Bare {
public:
    explicit Bare(Vfpga& top) : top_{top} {}

    void run(std::uint64_t clocks, bool skip) {
        while (clocks) {
            if (audio_.clocks() <= clocks_) audio_edge();
            const std::uint64_t most = std::min(clocks, audio_.clocks() - clocks_);
            const std::uint64_t rest = top_.rootp->fpga__DOT__clocks__DOT__rest;
            SData& left_out = top_.rootp->fpga__DOT__clocks__DOT__skip;
            left_out = skip ? static_cast<SData>(std::min(rest, most - 1)) : 0;
            top_.clk_i = !top_.clk_i;  // sim/fpga/root_clock.v
            top_.eval();
            clocks -= 1 + left_out;
            clocks_ += 1 + left_out;
        }
    }

private:
    void audio_edge() {
        top_.clk_audio_i = 1;
        top_.eval();
        top_.clk_audio_i = 0;
        audio_.next();
        audio_.next();
    }

    Vfpga& top_;
    sim::AsynchronousClock audio_ = sim::audio_clock(8'000);
    std::uint64_t clocks_ = 0;
};

}  // namespace

double bare_model_s(std::uint64_t clocks, bool skip) {
    VerilatedContext context;
    Vfpga top{&context};
    top.key_ni = 0xf;
    top.jp1_i = top.jp2_i = 0xffffffff;
    top.i2c_sdat_i = 1;
    top.irda_rxd_i = 1;
    top.ps2_clk_i = top.ps2_dat_i = 3;
    top.lw_bready_i = top.lw_rready_i = top.h2f_bready_i = top.h2f_rready_i = 1;
    top.rootp->fpga__DOT__clocks__DOT__moved = ALL;
    Bare bare{top};
    top.rst_i = top.rst_audio_i = 1;
    bare.run(100, false);
    top.rst_audio_i = 0;
    bare.run(8, false);
    top.rst_i = 0;
    bare.run(1, false);
    top.rootp->fpga__DOT__clocks__DOT__moved = 0;
    bare.run(CLOCKS_OF_SET_UP, skip);
    const auto begin = std::chrono::steady_clock::now();
    bare.run(clocks, skip);
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
    top.final();
    return took.count();
}

}  // namespace bench
