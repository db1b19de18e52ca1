// bad_address.cpp - a de1sim whose firmware reads where nothing is, after 50 ms.
#include <cstdlib>

#include "sim/run/cli.h"

#include <systemc>

namespace {

void bad_address(hal::Mmio& io, hal::Cpu& cpu) {
    for (int i = 0; i < 1000; ++i) cpu.idle();  // 50 us each
    io.read(0xFF2FF000);
}

}  // namespace

int sc_main(int argc, char** argv) { return sim::main(argc, argv, bad_address); }

int main(int argc, char** argv) {
    setenv("SYSTEMC_DISABLE_COPYRIGHT_MESSAGE", "1", 1);
    return sc_core::sc_elab_and_sim(argc, argv);
}
