// bare_clocks.cpp - runs the bare model for a number of clocks, so that a profiler can count
// instructions.
//
//   bare_clocks CLOCKS
#include <cstdio>
#include <cstdlib>

#include "tb/bench/bare_model.h"

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fputs("usage: bare_clocks CLOCKS\n", stderr);
        return 2;
    }
    bench::bare_model_s(std::strtoull(argv[1], nullptr, 10), true);
}
