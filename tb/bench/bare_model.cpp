#include "tb/bench/bare_model.h"

#include <chrono>

#include "Vfpga.h"
#include "verilated.h"

namespace bench {

double bare_model_s(std::uint64_t clocks) {
    VerilatedContext context;
    Vfpga top{&context};
    top.key_ni = 0xf;
    top.jp1_i = top.jp2_i = 0xffffffff;
    top.i2c_sdat_i = 1;
    top.lw_bready_i = top.lw_rready_i = top.h2f_bready_i = top.h2f_rready_i = 1;
    const auto run = [&top](std::uint64_t count) {
        while (count--) {
            top.clk_i = 1;
            top.eval();
            top.clk_i = 0;
            top.eval();
        }
    };
    top.rst_i = 1;
    run(8);
    top.rst_i = 0;
    const auto begin = std::chrono::steady_clock::now();
    run(clocks);
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
    top.final();
    return took.count();
}

}  // namespace bench
