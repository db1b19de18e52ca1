// never_swaps.cpp - a de1sim whose firmware draws into the back picture and never shows it.
#include <cstdlib>

#include "hal/display.h"
#include "sim/run/cli.h"

#include <systemc>

namespace {

void never_swaps(hal::Mmio& io, hal::Cpu& cpu) {
    hal::Display display{io};
    const std::uint32_t white[hal::Display::WIDTH / 2] = {0xffffffff};
    for (;;) {
        display.write_row(0, 0, white, hal::Display::WIDTH / 2);
        cpu.idle();
    }
}

}  // namespace

int sc_main(int argc, char** argv) { return sim::main(argc, argv, never_swaps); }

int main(int argc, char** argv) {
    setenv("SYSTEMC_DISABLE_COPYRIGHT_MESSAGE", "1", 1);
    return sc_core::sc_elab_and_sim(argc, argv);
}
