// throws.cpp - a de1sim whose firmware throws after 50 ms: an exception that is not caught, or with
// SW0 up std::bad_alloc.
#include <new>
#include <stdexcept>

#include "regmap.h"
#include "sim/program.h"

namespace {

void throws(hal::Mmio& io, hal::Cpu& cpu) {
    cpu.print("begun\n");
    for (int i = 0; i < 1000; ++i) cpu.idle();  // 50 us each
    if (io.read(regmap::SW_DATA) & 1) throw std::bad_alloc{};
    throw std::logic_error{"nobody thought of \x1b this"};
}

}  // namespace

int main(int argc, char** argv) { return sim::program(argc, argv, throws); }
