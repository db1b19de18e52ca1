#include "tb/bench/bare_model.h"

#include <algorithm>
#include <chrono>

#include "Vfpga.h"
#include "verilated.h"

namespace bench {

namespace {

constexpr unsigned ALL = 7;  // of moved_i

void run(Vfpga& top, std::uint64_t clocks, bool skip) {
    while (clocks) {
        top.skip_i = skip ? static_cast<SData>(std::min<std::uint64_t>(top.rest_o, clocks - 1)) : 0;
        top.clk_i = !top.clk_i;  // sim/fpga/root_clock.v
        top.eval();
        clocks -= 1 + top.skip_i;
    }
}

}  // namespace

double bare_model_s(std::uint64_t clocks, bool skip) {
    VerilatedContext context;
    Vfpga top{&context};
    top.key_ni = 0xf;
    top.jp1_i = top.jp2_i = 0xffffffff;
    top.i2c_sdat_i = 1;
    top.ps2_clk_i = top.ps2_dat_i = 3;
    top.lw_bready_i = top.lw_rready_i = top.h2f_bready_i = top.h2f_rready_i = 1;
    top.moved_i = ALL;
    top.rst_i = 1;
    run(top, 8, false);
    top.rst_i = 0;
    run(top, 1, false);
    top.moved_i = 0;
    run(top, CLOCKS_OF_SET_UP, skip);
    const auto begin = std::chrono::steady_clock::now();
    run(top, clocks, skip);
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
    top.final();
    return took.count();
}

}  // namespace bench
