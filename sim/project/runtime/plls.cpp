#include "sim/project/runtime/plls.h"

#include <cstdint>

namespace sim::project {

Clocks* clocks_of_design = nullptr;
int pll_locks_waiting = 0;

}  // namespace sim::project

using namespace sim::project;

extern "C" void de1sim_pll_set(int number, long long period_fs, long long high_fs) {
    if (clocks_of_design)
        clocks_of_design->set(static_cast<unsigned>(number), static_cast<std::uint64_t>(period_fs),
                              static_cast<std::uint64_t>(high_fs));
}

extern "C" void de1sim_pll_waits(int more) { pll_locks_waiting += more; }
